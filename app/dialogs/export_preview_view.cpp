#include "app/dialogs/export_preview_view.h"

#include "widgets/map/view/map_view.h"
#include "widgets/print/export_picture.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/object_names.h"

#include <QFontDatabase>
#include <QHeaderView>
#include <QPainter>
#include <QPlainTextEdit>
#include <QScrollArea>
#include <QTableView>

using namespace Qt::StringLiterals;

namespace berg {

/** A page as wide as there is room, to be scrolled, or the whole of it when it is much wider than
 * high; at night on red paper, as white would spoil eyes that are used to the dark. */
class PageView : public QWidget
{
public:
    explicit PageView(const Theme& theme)
        : m_paper(theme.isNight ? theme.mutedText : QColor(Qt::white))
    {
        QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
        policy.setHeightForWidth(true);
        setSizePolicy(policy);
    }

    void setPage(const QImage& page)
    {
        m_page = page;
        updateGeometry();
        update();
    }

    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override
    {
        return isWide() ? 0 : qRound(double(width - 2 * kMargin_px) / aspect()) + 2 * kMargin_px;
    }
    [[nodiscard]] QSize sizeHint() const override { return {400, heightForWidth(400)}; }

protected:
    void paintEvent(QPaintEvent* /*event*/) override
    {
        const QRect room = rect().marginsRemoved({kMargin_px, kMargin_px, kMargin_px, kMargin_px});
        QRect page(QPoint(), m_page.size().scaled(room.size(), Qt::KeepAspectRatio));
        page.moveCenter(room.center());
        page.moveTop(room.top());
        QPainter painter(this);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(page, m_page);
        painter.setCompositionMode(QPainter::CompositionMode_Multiply);
        painter.fillRect(page, m_paper);
    }

private:
    static constexpr int kMargin_px = 10; ///< of desk round the page

    [[nodiscard]] double aspect() const { return double(m_page.width()) / m_page.height(); }
    [[nodiscard]] bool isWide() const { return m_page.isNull() || aspect() > 1.4; }

    QColor m_paper;
    QImage m_page;
};

namespace {

/** A waypoint with the UAV that flies to it. */
struct WaypointRow
{
    const ExportUav* uav;
    const Visit* visit;
    int number; ///< of this UAV, from 1
};

std::vector<WaypointRow> waypointRows(const ExportContent& content)
{
    std::vector<WaypointRow> rows;
    for (const ExportUav& uav : content.uavs) {
        int number = 0;
        for (const Visit& visit : uav.visits)
            rows.push_back({.uav = &uav, .visit = &visit, .number = ++number});
    }
    return rows;
}

/** The name of the UAV only where there are several. */
CellSheet waypointSheet(const ExportPreviewPointer& preview, const QLocale& locale)
{
    const ExportContent& content = preview->content;
    const auto rows = std::make_shared<const std::vector<WaypointRow>>(waypointRows(content));
    const auto rowOf = [preview, rows](int row) -> const WaypointRow& {
        return (*rows)[static_cast<std::size_t>(row)];
    };
    CellSheet sheet{
        .columns = {{.title = ExportPreviewView::tr("No."),
                     .text = [rowOf](int row) { return QString::number(rowOf(row).number); },
                     .key = [rowOf](int row) { return double(rowOf(row).number); }},
                    {.title = ExportPreviewView::tr("Iceberg"),
                     .text =
                         [preview, rowOf](int row) {
                             const Visit& visit = *rowOf(row).visit;
                             return visit.iceberg
                                        ? QString::fromStdString(titleOf(preview->content, visit))
                                        : ExportPreviewView::tr("Home");
                         }},
                    {.title = ExportPreviewView::tr("Position"),
                     .text =
                         [preview, rowOf, locale](int row) {
                             return placeText(
                                 preview->content.frame.toGeographic(rowOf(row).visit->position_m),
                                 kPlaceDecimals, locale);
                         }},
                    {.title = ExportPreviewView::tr("Time"),
                     .text = [clock = MissionClock{.start = content.start},
                              rowOf](int row) { return clock.dateText(rowOf(row).visit->time_s); },
                     .key = [rowOf](int row) { return rowOf(row).visit->time_s; }}},
        .rows = static_cast<int>(rows->size())};
    if (areDistinguished(content.uavs))
        sheet.columns.push_back({.title = ExportPreviewView::tr("UAV"), .text = [rowOf](int row) {
                                     return QString::fromStdString(titleOf(rowOf(row).uav->uav));
                                 }});
    return sheet;
}

} // namespace

ExportPreviewView::ExportPreviewView(const Theme& theme, QWidget* parent)
    : QTabWidget(parent)
    , m_scroll(new QScrollArea)
    , m_page(new PageView(theme))
    , m_map(new MapView(m_document, m_selection))
    , m_waypoints(newCellTable(m_cells, u"exportWaypoints"_s, tr("Waypoints of the file")))
    , m_text(new QPlainTextEdit)
{
    m_map->setObjectName(u"exportMap"_s);
    m_map->setAccessibleName(tr("Map of what is exported"));
    m_map->setLocked(true);
    m_map->setTheme(theme);
    m_text->setObjectName(u"exportText"_s);
    m_text->setAccessibleName(tr("How the file begins"));
    m_text->setReadOnly(true);
    m_text->setLineWrapMode(QPlainTextEdit::NoWrap);
    m_text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_scroll->setWidget(m_page);
    m_scroll->setWidgetResizable(true);
    m_scroll->setBackgroundRole(QPalette::Mid);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_page->setObjectName(u"exportPage"_s);
    m_page->setAccessibleName(tr("Preview of the page"));
    addTab(m_scroll, tr("Page"));
    addTab(m_map, tr("Map"));
    addTab(m_waypoints, tr("Waypoints"));
    addTab(m_text, tr("File"));
    setTabVisible(indexOf(m_scroll), false);
}

ExportPreviewView::~ExportPreviewView()
{
    // Widgets that use members are deleted before these.
    delete m_map;
    delete m_waypoints;
}

void ExportPreviewView::showPreview(const ExportPreviewPointer& preview)
{
    const ExportFormat* format = findExportFormat(preview->request.formatId);
    const bool hasPath = format != nullptr && !format->holds.flownOnly;
    const bool isPage = !preview->image.isNull();
    const bool wasPage = isTabVisible(indexOf(m_scroll));
    setTabVisible(indexOf(m_scroll), isPage);
    setTabVisible(indexOf(m_map), hasPath && !isPage);
    setTabVisible(indexOf(m_waypoints), hasPath);
    setTabVisible(indexOf(m_text), !isPage);
    if (isPage != wasPage)
        setCurrentWidget(isPage    ? static_cast<QWidget*>(m_scroll)
                         : hasPath ? static_cast<QWidget*>(m_map)
                                   : m_text);
    m_page->setPage(preview->image);
    m_cells.setSheet(waypointSheet(preview, locale()));
    m_waypoints->resizeColumnsToContents();
    m_waypoints->horizontalHeader()->setStretchLastSection(true);
    m_text->setPlainText(preview->isWhole ? preview->head : preview->head + u"\n…"_s);
    m_map->setPicture(exportPicture(preview->content));
    if (!m_isFitted)
        m_map->camera().fit();
    m_isFitted = true;
}

} // namespace berg
