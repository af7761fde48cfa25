#include "widgets/charts/figure_view.h"

#include "widgets/charts/value_table.h"
#include "widgets/theme/accessible_roles.h"

#include <QAction>
#include <QContextMenuEvent>
#include <QFontMetricsF>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>

#include <algorithm>
#include <cmath>

namespace berg {
namespace {

constexpr double kReach_px = 16; // reach of the pointer
const PlotMark kChosenMark{.at = {}, .radius_px = 8, .shape = MarkShape::Ring};
constexpr double kBoxGap_px = 14; // distance of a readout from its point
constexpr double kBoxMargin_px = 7;
constexpr double kLine_px = 16;

QStringList linesOf(const DrawnItem& item)
{
    QStringList lines;
    for (const std::string& line : item.of.readout)
        lines << QString::fromStdString(line);
    return lines;
}

} // namespace

FigureView::FigureView(const Theme& theme, QWidget* parent)
    : QWidget(parent), m_theme(theme), m_values(addValueAction(*this))
{
    connect(m_values, &QAction::triggered, this, &FigureView::showValues);
    setAccessibleRole(*this, QAccessible::Chart);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void FigureView::setTheme(const Theme& theme)
{
    m_theme = theme;
    refresh();
}

void FigureView::setTitleShown(bool shown)
{
    m_titleShown = shown;
    refresh();
}

void FigureView::setChosen(std::optional<std::size_t> item)
{
    if (item == m_chosen)
        return;
    m_chosen = item;
    refresh();
}

void FigureView::refresh()
{
    Figure shown = figure();
    if (!m_titleShown)
        shown.title.clear();
    m_drawing = layOut(shown, {static_cast<double>(width()), static_cast<double>(height())},
                       figureFonts(m_theme));
    m_values->setEnabled(!m_drawing.items.empty());
    const DrawnItem* read = itemOf(m_hovered ? m_hovered : m_chosen);
    const QStringList lines = read != nullptr ? linesOf(*read) : QStringList();
    setAccessibleName(QString::fromStdString(shown.name));
    setAccessibleDescription(!shown.emptyText.empty() ? QString::fromStdString(shown.emptyText)
                             : lines.isEmpty()        ? QString::fromStdString(shown.description)
                                                      : lines.join(QStringLiteral(", ")));
    update();
}

void FigureView::forgetItems(std::size_t from)
{
    for (std::optional<std::size_t>* item : {&m_chosen, &m_hovered})
        if (*item && **item >= from)
            item->reset();
}

const DrawnItem* FigureView::itemOf(std::optional<std::size_t> id) const
{
    const auto item = std::find_if(m_drawing.items.begin(), m_drawing.items.end(),
                                   [&](const DrawnItem& one) { return one.of.id == id; });
    return item == m_drawing.items.end() ? nullptr : &*item;
}

std::optional<std::size_t> FigureView::itemNear(const QPointF& at) const
{
    std::optional<std::size_t> nearest;
    double nearest_px = kReach_px;
    for (const DrawnItem& item : m_drawing.items) {
        const double away_px = std::hypot(item.at.x - at.x(), item.at.y - at.y());
        if (away_px < nearest_px) {
            nearest = item.of.id;
            nearest_px = away_px;
        }
    }
    return nearest;
}

void FigureView::setHovered(std::optional<std::size_t> item)
{
    if (item == m_hovered)
        return;
    m_hovered = item;
    setCursor(item ? Qt::PointingHandCursor : Qt::ArrowCursor);
    refresh();
}

bool FigureView::event(QEvent* event)
{
    if (event->type() == QEvent::Leave)
        setHovered(std::nullopt);
    return QWidget::event(event);
}

void FigureView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    refresh();
}

void FigureView::mouseMoveEvent(QMouseEvent* event)
{
    setHovered(itemNear(event->position()));
}

void FigureView::mousePressEvent(QMouseEvent* event)
{
    const std::optional<std::size_t> item = itemNear(event->position());
    if (event->button() != Qt::LeftButton || !item || focusPolicy() == Qt::NoFocus)
        return QWidget::mousePressEvent(event);
    setChosen(item);
    emit itemActivated(*item);
}

void FigureView::keyPressEvent(QKeyEvent* event)
{
    const std::vector<DrawnItem>& items = m_drawing.items;
    if (items.empty())
        return QWidget::keyPressEvent(event);
    const DrawnItem* present = itemOf(m_chosen);
    const std::size_t last = items.size() - 1;
    const std::size_t at = present ? static_cast<std::size_t>(present - items.data()) : 0;
    const auto choose = [this](std::size_t id) {
        setChosen(id);
        emit itemChosen(id);
    };
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Up:
        return choose(items[present && at > 0 ? at - 1 : 0].of.id);
    case Qt::Key_Right:
    case Qt::Key_Down:
        return choose(items[present ? std::min(at + 1, last) : 0].of.id);
    case Qt::Key_Home:
        return choose(items.front().of.id);
    case Qt::Key_End:
        return choose(items.back().of.id);
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (present)
            emit itemActivated(present->of.id);
        return;
    default:
        QWidget::keyPressEvent(event);
    }
}

void FigureView::contextMenuEvent(QContextMenuEvent* event)
{
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("figureMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(m_values);
    menu->popup(event->globalPos());
}

/** Shows the readouts of all items as a table, in the order of the arrow keys. */
void FigureView::showValues()
{
    QStringList points;
    QStringList values;
    for (const DrawnItem& item : m_drawing.items) {
        QStringList lines = linesOf(item);
        points << (lines.isEmpty() ? QString() : lines.takeFirst());
        values << lines.join(QStringLiteral(", "));
    }
    ValueTable::open(
        accessibleName(),
        {.columns = {{.title = tr("Point"), .text = [points](int row) { return points[row]; }},
                     {.title = tr("Values"), .text = [values](int row) { return values[row]; }}},
         .rows = static_cast<int>(points.size())},
        this);
}

/** Paints the readout beside its point, on the side with room. */
void FigureView::paintReadout(QPainter& painter, const DrawnItem& item) const
{
    const FigureFonts fonts = figureFonts(m_theme);
    const auto fontOfLine = [](std::size_t k) {
        return k == 0 ? FigureFont::Strong : FigureFont::Small;
    };
    const std::vector<std::string>& lines = item.of.readout;
    double width_px = 0;
    for (std::size_t k = 0; k < lines.size(); ++k)
        width_px = std::max(width_px, fonts.width_px(lines[k], fontOfLine(k)));
    QRectF box(0, 0, width_px + 2 * kBoxMargin_px,
               static_cast<double>(lines.size()) * kLine_px + 2 * kBoxMargin_px);
    const bool isRight = item.at.x + kBoxGap_px + box.width() < width();
    box.moveLeft(isRight ? item.at.x + kBoxGap_px : item.at.x - kBoxGap_px - box.width());
    box.moveTop(
        std::clamp(item.at.y - box.height() / 2, 2.0, std::max(2.0, height() - box.height() - 2)));
    painter.setPen(QPen(m_theme.chartAxis, 1));
    painter.setBrush(m_theme.panel);
    painter.drawRoundedRect(box, 4, 4);
    Drawing texts;
    PixelRect row{box.left() + kBoxMargin_px, box.top() + kBoxMargin_px, box.right(), 0};
    for (std::size_t k = 0; k < lines.size(); ++k) {
        row.bottom = row.top + kLine_px;
        texts.texts.push_back({.text = lines[k], .rect = row, .font = fontOfLine(k), .ink = {}});
        row.top = row.bottom;
    }
    paintDrawing(painter, texts, m_theme);
}

void FigureView::paintFigure(QPainter& painter) const
{
    painter.fillRect(rect(), m_theme.chart);
    paintDrawing(painter, m_drawing, m_theme);
    painter.setRenderHint(QPainter::Antialiasing);
    if (const DrawnItem* item = itemOf(m_chosen))
        paintMark(painter, toQt(item->at), kChosenMark, m_theme);
}

void FigureView::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    paintFigure(painter);
    if (const DrawnItem* read = itemOf(m_hovered || !hasFocus() ? m_hovered : m_chosen))
        paintReadout(painter, *read);
    if (hasFocus()) {
        painter.setPen(QPen(m_theme.plan, 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

} // namespace berg
