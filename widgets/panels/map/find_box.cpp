#include "widgets/panels/map/find_box.h"

#include "widgets/places/places.h"
#include "widgets/theme/accessible_roles.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>
#include <array>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kEdge_px = 12;
constexpr int kWidth_px = 460;
constexpr double kRadius_px = 7;
constexpr std::size_t kMostShown = 9;

/** Names by `FindKind`; places have names of their own below. */
constexpr std::array kKindTexts{
    QT_TRANSLATE_NOOP("berg::FindBox", "Iceberg"), QT_TRANSLATE_NOOP("berg::FindBox", "UAV"),
    QT_TRANSLATE_NOOP("berg::FindBox", "Coordinate"), QT_TRANSLATE_NOOP("berg::FindBox", "Command"),
    QT_TRANSLATE_NOOP("berg::FindBox", "Field")};

/** Names by `PlaceKind`. */
constexpr std::array kPlaceTexts{QT_TRANSLATE_NOOP("berg::FindBox", "Sea or bay"),
                                 QT_TRANSLATE_NOOP("berg::FindBox", "Island or coast"),
                                 QT_TRANSLATE_NOOP("berg::FindBox", "Cape"),
                                 QT_TRANSLATE_NOOP("berg::FindBox", "Town or station"),
                                 QT_TRANSLATE_NOOP("berg::FindBox", "Oil or gas field")};

QString kindText(const FindItem& item)
{
    return FindBox::tr(item.placeKind ? kPlaceTexts.at(static_cast<std::size_t>(*item.placeKind))
                                      : kKindTexts.at(static_cast<std::size_t>(item.kind)));
}

QString rowText(const FindItem& item)
{
    QString text = item.isFavourite ? u"★ "_s + item.text : item.text;
    const bool isObject = item.kind == FindKind::Iceberg || item.kind == FindKind::Uav;
    if (isObject && item.other != item.text && !item.other.isEmpty())
        text += u" (%1)"_s.arg(item.other);
    text += u"   –   "_s + kindText(item);
    return item.hint.isEmpty() ? text : text + u", "_s + item.hint;
}

} // namespace

FindBox::FindBox(QWidget* parent) : QWidget(parent)
{
    setObjectName(u"findBox"_s);
    setCursor(Qt::ArrowCursor);
    setAttribute(Qt::WA_NoMousePropagation); // a press beside the field must not reach the map
    addRows();
    connect(m_field, &QLineEdit::textEdited, this, &FindBox::showMatches);
    connect(m_field, &QLineEdit::returnPressed, this, &FindBox::choose);
    connect(m_list, &QListWidget::itemClicked, this, &FindBox::choose);
    connect(m_list, &QListWidget::currentRowChanged, this, &FindBox::showCurrent);
    connect(m_star, &QToolButton::clicked, this, &FindBox::toggleFavourite);
    const auto asked = [this](QPushButton* button, auto signal) {
        connect(button, &QPushButton::clicked, this, [this, signal] {
            const FindItem* item = current();
            if (item == nullptr)
                return;
            const LatLon at = item->at;
            dismiss();
            emit(this->*signal)(at);
        });
    };
    asked(m_move, &FindBox::moveRequested);
    asked(m_new, &FindBox::newRequested);
    m_field->installEventFilter(this);
    parent->installEventFilter(this);
    hide();
}

void FindBox::addRows()
{
    m_field = new QLineEdit;
    m_field->setObjectName(u"findField"_s);
    m_field->setClearButtonEnabled(true);
    m_star = new QToolButton;
    m_star->setObjectName(u"findFavourite"_s);
    m_star->setText(u"★"_s);
    m_star->setCheckable(true);
    m_star->setToolTip(tr("Favourite: listed when the box is opened"));
    m_star->setAccessibleName(tr("Favourite"));
    m_list = new QListWidget;
    m_list->setObjectName(u"findList"_s);
    m_list->setAccessibleName(tr("Found"));
    followSelection(*m_list);
    m_list->setFocusPolicy(Qt::NoFocus); // the arrow keys of the line move in the list
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_reason = new QLabel;
    m_reason->setObjectName(u"findReason"_s);
    m_reason->setWordWrap(true);
    m_move = new QPushButton(tr("Move the scenario here…"));
    m_move->setObjectName(u"findMoveButton"_s);
    m_new = new QPushButton(tr("New scenario here"));
    m_new->setObjectName(u"findNewButton"_s);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(6);
    auto* row = new QHBoxLayout;
    row->addWidget(m_field, 1);
    row->addWidget(m_star);
    column->addLayout(row);
    column->addWidget(m_list);
    column->addWidget(m_reason);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_new);
    buttons->addWidget(m_move);
    buttons->addStretch();
    column->addLayout(buttons);
}

void FindBox::setTheme(const Theme& theme)
{
    m_theme = theme;
    update();
}

void FindBox::open(Request request)
{
    m_request = std::move(request);
    if (m_request.asksWhere)
        std::erase_if(m_request.items,
                      [](const FindItem& item) { return item.kind != FindKind::Place; });
    m_field->setPlaceholderText(m_request.asksWhere
                                    ? tr("Where is the new scenario? A place or coordinate")
                                    : tr("Iceberg, UAV, place, coordinate or command"));
    m_field->setAccessibleName(m_field->placeholderText());
    m_field->clear();
    show();
    raise();
    showMatches();
    m_field->setFocus(Qt::ShortcutFocusReason);
}

void FindBox::showMatches()
{
    m_found = findMatches(m_field->text(), m_request.items, kMostShown);
    m_list->clear();
    for (FindItem& item : m_found) {
        item.isFavourite = item.isFavourite || isFavourite(favouriteKey(item));
        m_list->addItem(rowText(item));
    }
    m_list->setCurrentRow(m_found.empty() ? -1 : 0);
    const int rows = static_cast<int>(m_found.size());
    m_list->setVisible(rows > 0);
    if (rows > 0)
        m_list->setFixedHeight(rows * m_list->sizeHintForRow(0) + 2 * m_list->frameWidth());
    showCurrent();
    // An incomplete coordinate is not reported as missing.
    const QString text = m_field->text().trimmed();
    if (rows == 0 && !text.isEmpty() &&
        std::ranges::none_of(text, [](QChar c) { return c.isDigit(); }))
        explain(tr("Nothing found"));
}

/** A typed coordinate may be a favourite too. */
bool FindBox::isFavourite(const QString& key) const
{
    return std::ranges::any_of(m_request.items, [&](const FindItem& item) {
        return item.isFavourite && favouriteKey(item) == key;
    });
}

/** Updates the actions for the current item of the list. */
void FindBox::showCurrent()
{
    const FindItem* item = current();
    const bool isPlace = item != nullptr && item->kind == FindKind::Place;
    m_star->setEnabled(item != nullptr && !favouriteKey(*item).isEmpty());
    m_star->setChecked(item != nullptr && item->isFavourite);
    m_new->setVisible(isPlace && !m_request.asksWhere);
    m_move->hide();
    explain({});
}

const FindItem* FindBox::current() const
{
    const int row = m_list->currentRow();
    return row >= 0 && row < static_cast<int>(m_found.size())
               ? &m_found[static_cast<std::size_t>(row)]
               : nullptr;
}

void FindBox::choose()
{
    if (!isVisible())
        return;
    if (current() == nullptr) {
        const auto found = findPlace(m_field->text());
        if (const auto* reason = std::get_if<QString>(&found))
            explain(m_field->text().trimmed().isEmpty() ? QString() : *reason);
        return;
    }
    const FindItem item = *current(); // a copy, because a receiver may open the box again
    if (m_request.asksWhere) {
        dismiss();
        emit whereChosen(item.at);
    } else if (item.kind == FindKind::Place && !pointInReach(item.at, m_request.origin)) {
        chooseFarPlace(item);
    } else {
        dismiss();
        if (item.kind == FindKind::Place)
            emit placeChosen(item.at, item.key.isEmpty() ? QString() : item.text);
        else if (item.kind == FindKind::Command)
            emit commandChosen(item.key);
        else if (item.kind == FindKind::Field)
            emit fieldChosen(item.key);
        else
            emit objectChosen(item.key.toStdString());
    }
}

void FindBox::chooseFarPlace(const FindItem& item)
{
    m_move->setVisible(m_request.mayMove);
    explain(beyondReachText(item.at, m_request.origin, locale()));
}

void FindBox::toggleFavourite()
{
    const FindItem* item = current();
    if (item == nullptr)
        return;
    const QString key = favouriteKey(*item);
    const bool isFavourite = m_star->isChecked();
    const int row = m_list->currentRow();
    bool isKnown = false;
    for (FindItem& one : m_request.items)
        if (favouriteKey(one) == key) {
            one.isFavourite = isFavourite;
            isKnown = true;
        }
    if (!isKnown) { // a typed coordinate
        m_request.items.push_back(*item);
        m_request.items.back().isFavourite = isFavourite;
    }
    m_found[static_cast<std::size_t>(row)].isFavourite = isFavourite;
    m_list->item(row)->setText(rowText(m_found[static_cast<std::size_t>(row)]));
    emit favouriteChanged(key, isFavourite);
}

void FindBox::explain(const QString& reason)
{
    m_reason->setText(reason);
    m_reason->setVisible(!reason.isEmpty());
    place();
}

void FindBox::dismiss()
{
    if (isHidden())
        return;
    emit closed(); // emitted first, so that the focus is not passed on as by the Tab key
    hide();
}

void FindBox::place()
{
    const int width_px = std::min(kWidth_px, parentWidget()->width() - 2 * kEdge_px);
    layout()->activate();
    const int height_px = layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width_px)
                                                        : sizeHint().height();
    setGeometry((parentWidget()->width() - width_px) / 2, kEdge_px, width_px, height_px);
}

void FindBox::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(m_theme.panelLine, 1));
    painter.setBrush(m_theme.panel);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), kRadius_px, kRadius_px);
}

void FindBox::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape)
        dismiss();
    else
        QWidget::keyPressEvent(event);
    event->accept(); // keys never reach the map below
}

bool FindBox::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize && watched == parentWidget() && isVisible())
        place();
    if (event->type() == QEvent::MouseButtonPress && watched == parentWidget())
        dismiss();
    if (watched == m_field && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const int last = m_list->count() - 1;
        if ((key == Qt::Key_Down || key == Qt::Key_Up) && last >= 0) {
            const int step = key == Qt::Key_Down ? 1 : -1;
            m_list->setCurrentRow(std::clamp(m_list->currentRow() + step, 0, last));
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace berg
