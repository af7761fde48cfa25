#include "widgets/manual/manual_window.h"

#include "widgets/theme/accessible_roles.h"
#include "widgets/theme/theme.h"

#include <QAction>
#include <QDir>
#include <QEvent>
#include <QHeaderView>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QShortcut>
#include <QSplitter>
#include <QTextBlock>
#include <QTextBrowser>
#include <QToolBar>
#include <QTreeWidget>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr QSize kSize_px{1080, 760};
constexpr int kList_px = 300;
constexpr int kPicture_px = 640; // width as in the HTML; the document scales coarsely
constexpr int kPlaceRole = Qt::UserRole;
constexpr double kShade = 0.08; // background of code and table headers, towards the text

/** Browser that generates pages on demand; pictures are files. */
class Pages : public QTextBrowser
{
public:
    Pages(const Manual& manual, QString pictures)
        : m_manual(manual), m_pictures(std::move(pictures))
    {
    }

protected:
    QVariant loadResource(int type, const QUrl& name) override
    {
        if (type != QTextDocument::HtmlResource)
            return QImage(QDir(m_pictures).filePath(name.path()))
                .scaledToWidth(qRound(kPicture_px * devicePixelRatioF()), Qt::SmoothTransformation);
        const ManualChapter* chapter = m_manual.chapterAt(name.path());
        return chapter == nullptr ? QString() : chapter->html(m_pictures, true);
    }

private:
    const Manual& m_manual;
    QString m_pictures;
};

/** URL of a place such as "planning#tau". */
QUrl pageOf(const QString& place)
{
    QUrl url;
    url.setPath(place.section(u'#', 0, 0).section(u'.', 0, 0) + u".html"_s);
    if (const QString anchor = place.section(u'#', 1); !anchor.isEmpty())
        url.setFragment(anchor);
    return url;
}

QString placeOf(const QUrl& page)
{
    const QString chapter = page.path().section(u'.', 0, 0);
    return page.hasFragment() ? chapter + u'#' + page.fragment() : chapter;
}

QTreeWidgetItem* newItem(const QString& text, const QString& place)
{
    auto* item = new QTreeWidgetItem({text});
    item->setData(0, kPlaceRole, place);
    item->setToolTip(0, text);
    return item;
}

} // namespace

ManualWindow::ManualWindow(QWidget* parent)
    : QWidget(parent, Qt::Window)
    , m_language(manualLanguage())
    , m_manual(readManual(m_language))
    , m_list(new QTreeWidget)
    , m_text(new Pages(m_manual, manualPictures(m_language)))
{
    setObjectName(u"manualWindow"_s);
    setWindowTitle(tr("Bergwatch manual"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    addBar();
    column->addWidget(m_bar);
    m_list->setObjectName(u"manualList"_s);
    m_list->setAccessibleName(tr("Contents of the manual"));
    followSelection(*m_list);
    m_list->setHeaderHidden(true);
    m_list->setTextElideMode(Qt::ElideRight);
    m_text->setObjectName(u"manualText"_s);
    m_text->setAccessibleName(tr("Text of the manual"));
    m_text->document()->setDocumentMargin(16);
    auto* halves = new QSplitter;
    halves->addWidget(m_list);
    halves->addWidget(m_text);
    halves->setStretchFactor(1, 1);
    halves->setSizes({kList_px, kSize_px.width() - kList_px});
    column->addWidget(halves, 1);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &ManualWindow::go);
    connect(m_text, &QTextBrowser::sourceChanged, this, &ManualWindow::follow);
    addKeys();
    applyPalette();
    showContents();
    resize(kSize_px);
}

void ManualWindow::addBar()
{
    m_bar = new QToolBar;
    const auto add = [this](const char* name, const QString& text, const QKeySequence& key,
                            const auto& slot) {
        QAction* action = m_bar->addAction(text, this, slot);
        action->setObjectName(QLatin1String(name));
        action->setShortcut(key);
        action->setToolTip(u"%1 (%2)"_s.arg(text, key.toString(QKeySequence::NativeText)));
        return action;
    };
    QAction* back =
        add("manualBack", tr("Back"), QKeySequence::Back, [this] { m_text->backward(); });
    QAction* forward =
        add("manualForward", tr("Forward"), QKeySequence::Forward, [this] { m_text->forward(); });
    back->setEnabled(false);
    forward->setEnabled(false);
    connect(m_text, &QTextBrowser::backwardAvailable, back, &QAction::setEnabled);
    connect(m_text, &QTextBrowser::forwardAvailable, forward, &QAction::setEnabled);
    add("manualLarger", tr("Larger text"), QKeySequence::ZoomIn, [this] { m_text->zoomIn(); });
    add("manualSmaller", tr("Smaller text"), QKeySequence::ZoomOut, [this] { m_text->zoomOut(); });
    m_bar->addSeparator();
    m_search = new QLineEdit;
    m_search->setObjectName(u"manualSearch"_s);
    m_search->setPlaceholderText(tr("Search the manual (Ctrl+F)"));
    m_search->setAccessibleName(tr("Search the manual"));
    m_search->setClearButtonEnabled(true);
    m_bar->addWidget(m_search);
    add("manualPrevious", tr("Previous"), QKeySequence::FindPrevious, [this] { stepHit(-1); });
    add("manualNext", tr("Next"), QKeySequence::FindNext, [this] { stepHit(+1); });
    m_found = new QLabel;
    m_found->setObjectName(u"manualFound"_s);
    m_found->setContentsMargins(8, 0, 8, 0);
    m_bar->addWidget(m_found);
    connect(m_search, &QLineEdit::textChanged, this, &ManualWindow::search);
    connect(m_search, &QLineEdit::returnPressed, this, [this] { stepHit(+1); });
}

void ManualWindow::addKeys()
{
    const auto add = [this](const QKeySequence& key, const auto& slot) {
        connect(new QShortcut(key, this), &QShortcut::activated, this, slot);
    };
    add(QKeySequence::Find, [this] {
        m_search->setFocus();
        m_search->selectAll();
    });
    add(Qt::Key_Escape, [this] {
        if (m_search->text().isEmpty())
            close();
        else
            m_search->clear();
    });
}

void ManualWindow::showContents()
{
    const QSignalBlocker blocker(m_list); // filling the list must not navigate
    m_list->clear();
    for (const ManualChapter& chapter : m_manual.chapters) {
        QTreeWidgetItem* top = newItem(chapter.title(), chapter.name);
        m_list->addTopLevelItem(top);
        for (const MarkdownBlock& block : chapter.blocks)
            if (block.kind == MarkdownKind::Heading && block.level == 2)
                top->addChild(newItem(plainText(block.text), chapter.name + u'#' + block.id));
    }
    m_found->clear();
    follow(m_text->source());
}

/** Lists lines that contain all the words instead of the contents. */
void ManualWindow::search(const QString& words)
{
    markWords();
    if (words.trimmed().isEmpty()) {
        showContents();
        return;
    }
    const QSignalBlocker blocker(m_list);
    m_list->clear();
    const std::vector<ManualHit> hits = m_manual.search(words);
    QTreeWidgetItem* under = nullptr;
    for (const ManualHit& hit : hits) {
        if (under == nullptr || under->text(0) != hit.heading) {
            under = newItem(hit.heading, hit.place);
            m_list->addTopLevelItem(under);
        }
        under->addChild(newItem(hit.line, hit.place));
    }
    m_list->expandAll();
    m_found->setText(hits.empty() ? tr("Not found") : tr("Lines found: %1").arg(hits.size()));
}

/** Moves to the next or previous result, cyclically. */
void ManualWindow::stepHit(int step)
{
    std::vector<QTreeWidgetItem*> lines;
    int at = step > 0 ? -1 : 0;
    for (int i = 0; !m_search->text().trimmed().isEmpty() && i < m_list->topLevelItemCount(); ++i)
        for (int k = 0; k < m_list->topLevelItem(i)->childCount(); ++k) {
            lines.push_back(m_list->topLevelItem(i)->child(k));
            if (lines.back() == m_list->currentItem())
                at = static_cast<int>(lines.size()) - 1;
        }
    const int count = static_cast<int>(lines.size());
    if (count > 0)
        m_list->setCurrentItem(lines[static_cast<std::size_t>((at + step + count) % count)]);
}

void ManualWindow::go(const QTreeWidgetItem* item)
{
    if (item == nullptr)
        return;
    showPlace(item->data(0, kPlaceRole).toString());
    if (item->parent() != nullptr && !m_search->text().trimmed().isEmpty())
        showLine(item->text(0));
}

/** Scrolls to a found line, which may be far down in a table. */
void ManualWindow::showLine(const QString& line)
{
    const QString begin = line.section(u" · "_s, 0, 0); // first cell of a row
    const auto isFoundFrom = [&](QTextBlock block) {
        while (block.isValid() && !block.text().contains(begin))
            block = block.next();
        if (!block.isValid())
            return false;
        QTextCursor cursor(block);
        cursor.setPosition(block.position() + static_cast<int>(block.text().indexOf(begin)));
        m_text->setTextCursor(cursor);
        m_text->ensureCursorVisible();
        return true;
    };
    // Beside a table, a position in the view can belong to a row below.
    if (!isFoundFrom(m_text->cursorForPosition({}).block()))
        isFoundFrom(m_text->document()->begin());
}

void ManualWindow::showPlace(const QString& place)
{
    m_text->setSource(pageOf(place), QTextDocument::HtmlResource);
}

QString ManualWindow::place() const
{
    return placeOf(m_text->source());
}

/** Selects the page in the contents; `page` is passed because the browser's source lags behind. */
void ManualWindow::follow(const QUrl& page)
{
    markWords();
    if (!m_search->text().trimmed().isEmpty())
        return;
    const QSignalBlocker blocker(m_list);
    const QString shown = placeOf(page);
    for (QTreeWidgetItemIterator it(m_list); *it != nullptr; ++it)
        if (const QString of = (*it)->data(0, kPlaceRole).toString();
            of == shown || of == shown.section(u'#', 0, 0))
            m_list->setCurrentItem(*it);
}

/** Highlights the search words in the text. */
void ManualWindow::markWords()
{
    QList<QTextEdit::ExtraSelection> marks;
    for (const QString& word : m_search->text().split(u' ', Qt::SkipEmptyParts))
        for (QTextCursor at = m_text->document()->find(word); !at.isNull();
             at = m_text->document()->find(word, at)) {
            QTextEdit::ExtraSelection mark;
            mark.cursor = at;
            mark.format.setBackground(palette().highlight());
            mark.format.setForeground(palette().highlightedText());
            marks.push_back(mark);
        }
    m_text->setExtraSelections(marks);
}

/** Sets the colours of tables and code from the palette, which changes with the theme. */
void ManualWindow::applyPalette()
{
    const QColor text = palette().color(QPalette::Text);
    const QColor base = palette().color(QPalette::Base);
    m_text->document()->setDefaultStyleSheet(
        u"pre, th { background-color: %1; } pre { white-space: pre-wrap; } a { color: %2; }"_s.arg(
            mixed(base, text, kShade).name(), palette().color(QPalette::Link).name()));
}

void ManualWindow::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_text != nullptr) {
        applyPalette();
        m_text->reload();
    }
}

} // namespace berg
