#include "app/start/start_page.h"

#include "app/start/start_items.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kMargin_px = 28;
constexpr int kGap_px = 14;
constexpr int kCommands_px = 300; ///< at least
constexpr int kWidest_px = 1500;  ///< beyond, the page stays in the middle of the window
constexpr int kMostCardColumns = 4;

} // namespace

StartPage::StartPage(const QString& continued, bool showAtStart, bool offersTour, QWidget* parent)
    : QWidget(parent), m_content(new StartContent(parent))
{
    setObjectName(u"startPage"_s);
    setFocusPolicy(Qt::ClickFocus);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(kMargin_px, kMargin_px, kMargin_px, kGap_px);
    row->setSpacing(2 * kMargin_px);
    row->addWidget(makeCommands(continued, showAtStart, offersTour));
    row->addWidget(makeExamples(), 1);
    connect(m_content, &StartContent::recentRead, this, &StartPage::showRecent);
    connect(m_content, &StartContent::examplePainted, this, &StartPage::showExample);
    parent->installEventFilter(this);
}

StartPage::~StartPage()
{
    if (m_content) // else the window ends, and it went first
        m_content->finish();
}

QPushButton* StartPage::addCommand(QVBoxLayout& column, const char* name, const QString& text,
                                   void (StartPage::*intent)()) const
{
    auto* button = new QPushButton(text);
    button->setObjectName(QLatin1String(name));
    button->setAutoDefault(true); // Enter presses it, not only Space
    connect(button, &QPushButton::clicked, this, intent);
    column.addWidget(button);
    return button;
}

QWidget* StartPage::makeCommands(const QString& continued, bool showAtStart, bool offersTour)
{
    auto* commands = new QWidget;
    auto* column = new QVBoxLayout(commands);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGap_px / 2);
    m_title = new QLabel(u"Bergwatch"_s);
    column->addWidget(m_title);
    m_captions.push_back(new QLabel(tr("Keep watch over drifting icebergs.")));
    column->addWidget(m_captions.back());
    column->addSpacing(kGap_px);
    m_continue = addCommand(*column, "continueButton", QString(), &StartPage::continueRequested);
    const QString wide = tr("Continue with %1").arg(continued);
    m_continue->setText(
        m_continue->fontMetrics().elidedText(wide, Qt::ElideRight, kCommands_px - 24));
    m_continue->setToolTip(wide);
    m_continue->setDefault(true);
    addCommand(*column, "startNewButton", tr("New scenario"), &StartPage::newRequested);
    addCommand(*column, "startOpenButton", tr("Open..."), &StartPage::openRequested);
    addCommand(*column, "startImportButton", tr("Import sightings..."),
               &StartPage::importRequested);
    addCommand(*column, "startTourButton",
               offersTour ? tr("New here? Take the tour, three steps") : tr("Tour"),
               &StartPage::tourRequested);
    column->addSpacing(kGap_px);
    m_headings.push_back(new QLabel(tr("Recent files")));
    column->addWidget(m_headings.back());
    auto* list = new QWidget;
    m_recent = new QVBoxLayout(list);
    m_recent->setContentsMargins(0, 0, 0, 0);
    m_recent->setSpacing(4);
    m_recent->addStretch(1);
    auto* scroll = new QScrollArea;
    scroll->setObjectName(u"recentList"_s);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(list);
    column->addWidget(scroll, 1);
    auto* again = new QCheckBox(tr("Show this page at the start"));
    again->setObjectName(u"showAtStartBox"_s);
    again->setChecked(showAtStart);
    connect(again, &QCheckBox::toggled, this, &StartPage::showAtStartEdited);
    column->addWidget(again);
    commands->setFixedWidth(std::max(kCommands_px, commands->sizeHint().width()));
    return commands;
}

QWidget* StartPage::makeExamples()
{
    auto* side = new QWidget;
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGap_px);
    m_headings.push_back(new QLabel(tr("Examples")));
    column->addWidget(m_headings.back());
    auto* sheet = new QWidget;
    m_grid = new QGridLayout(sheet);
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setSpacing(kGap_px);
    m_grid->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    for (const QString& path : examplePaths()) {
        auto* card = new ExampleCard;
        card->setObjectName(u"example "_s + path.section(u'/', -1));
        connect(card, &ExampleCard::clicked, this, [this, path] { emit exampleChosen(path); });
        m_cards.push_back(card);
    }
    m_examples = new QScrollArea;
    m_examples->setWidgetResizable(true);
    m_examples->setFrameShape(QFrame::NoFrame);
    m_examples->setFocusPolicy(Qt::NoFocus);
    m_examples->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_examples->setWidget(sheet);
    m_examples->viewport()->installEventFilter(this); // decides the number of columns
    column->addWidget(m_examples, 1);
    return side;
}

void StartPage::setTheme(const Theme& theme)
{
    m_theme = theme;
    m_title->setFont(theme.figure());
    for (QLabel* heading : m_headings)
        heading->setFont(theme.strong());
    QPalette muted = palette();
    muted.setColor(QPalette::WindowText, theme.mutedText);
    for (QLabel* caption : m_captions)
        caption->setPalette(muted);
    for (ExampleCard* card : m_cards)
        card->setTheme(theme);
    m_content->paintExamples(theme, devicePixelRatioF());
    if (!m_recentPaths.isEmpty())
        setRecent(m_recentPaths); // their pictures
    update();
}

void StartPage::setRecent(const QStringList& paths)
{
    m_recentPaths = paths;
    m_content->readRecent(paths, m_theme, devicePixelRatioF());
}

void StartPage::showRecent(const QList<RecentFile>& files)
{
    while (m_recent->count() > 1) {
        const std::unique_ptr<QLayoutItem> item(m_recent->takeAt(0));
        item->widget()->deleteLater();
    }
    const auto add = [this](QWidget* widget) {
        m_recent->insertWidget(m_recent->count() - 1, widget);
    };
    for (const RecentFile& file : files) {
        auto* row = new RecentRow(file, m_theme);
        const QString path = file.path;
        if (file.exists)
            connect(row, &RecentRow::clicked, this, [this, path] { emit fileChosen(path); });
        connect(row, &RecentRow::removeRequested, this,
                [this, path] { emit removeRequested(path); });
        add(row);
    }
    if (files.isEmpty())
        add(new QLabel(tr("No files yet")));
}

void StartPage::showExample(int place, const Example& example, const QColor& sea)
{
    if (sea == m_theme.sea) // else painted for the appearance before
        m_cards[static_cast<std::size_t>(place)]->setExample(example);
}

void StartPage::arrangeExamples()
{
    const int room_px = m_examples->viewport()->width() + kGap_px;
    const int columns =
        std::clamp(room_px / (m_cards.front()->width() + kGap_px), 1, kMostCardColumns);
    for (std::size_t i = 0; i < m_cards.size(); ++i)
        m_grid->addWidget(m_cards[i], static_cast<int>(i) / columns, static_cast<int>(i) % columns);
}

void StartPage::setTop(int top_px)
{
    m_top_px = top_px;
    place();
}

void StartPage::place()
{
    const QSize room = parentWidget()->size();
    setGeometry(0, m_top_px, room.width(), room.height() - m_top_px);
    const int side_px = std::max(kMargin_px, (room.width() - kWidest_px) / 2);
    layout()->setContentsMargins(side_px, kMargin_px, side_px, kGap_px);
    raise();
}

void StartPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_continue->setFocus();
}

void StartPage::paintEvent(QPaintEvent* /*event*/)
{
    QPainter(this).fillRect(rect(), palette().color(QPalette::Window));
}

/** The focus goes round on the page: what lies below cannot be seen. */
bool StartPage::focusNextPrevChild(bool next)
{
    QWidget* from = focusWidget() != nullptr ? focusWidget() : this;
    for (QWidget* to = from;;) {
        to = next ? to->nextInFocusChain() : to->previousInFocusChain();
        if (to == from)
            return false;
        if (isAncestorOf(to) && to->isVisibleTo(this) && to->isEnabled() &&
            (to->focusPolicy() & Qt::TabFocus) != 0) {
            to->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
            m_examples->ensureWidgetVisible(to);
            return true;
        }
    }
}

/** Keys without a modifier belong to the page, not to the tools and the flight below it. */
bool StartPage::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride &&
        static_cast<QKeyEvent*>(event)->modifiers() == Qt::NoModifier) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

bool StartPage::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        watched == parentWidget() ? place() : arrangeExamples();
    return QWidget::eventFilter(watched, event);
}

void StartPage::keyPressEvent(QKeyEvent* event)
{
    const int key = event->key();
    if (key == Qt::Key_Escape)
        emit dismissed();
    else if (key == Qt::Key_Return || key == Qt::Key_Enter)
        emit continueRequested();
    else
        QWidget::keyPressEvent(event);
}

} // namespace berg
