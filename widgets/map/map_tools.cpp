#include "widgets/map/map_tools.h"

#include "core/base/angles.h"
#include "widgets/map/map_view.h"
#include "widgets/map/placing_tools.h"
#include "widgets/map/select_tool.h"
#include "widgets/model/scenario_edits.h"

#include <QApplication>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct MapTools
{
    Q_DECLARE_TR_FUNCTIONS(MapTools)
};

/** Drags the map itself. */
class PanTool final : public MapTool
{
public:
    using MapTool::MapTool;

    void press(const MapPointer& pointer) override { m_last = pointer.at_px; }
    void move(const MapPointer& pointer) override
    {
        if (!m_last)
            return;
        context().view.panBy(pointer.at_px - *m_last);
        m_last = pointer.at_px;
    }
    void release(const MapPointer&) override { m_last.reset(); }
    [[nodiscard]] bool isBusy() const override { return m_last.has_value(); }
    void cancel() override { m_last.reset(); }
    void documentChanged() override {}
    [[nodiscard]] QCursor cursor(const std::string&) const override
    {
        return m_last ? Qt::ClosedHandCursor : Qt::OpenHandCursor;
    }
    [[nodiscard]] QString status() const override
    {
        return MapTools::tr("Drag moves the map, the wheel zooms. Esc leaves the tool.");
    }

private:
    std::optional<QPointF> m_last;
};

} // namespace

bool MapTool::key(const QKeyEvent&)
{
    return false;
}

void MapTool::paint(QPainter&) const {}

std::unique_ptr<EditGesture> MapTool::newGesture(const QString& text) const
{
    return std::make_unique<EditGesture>(
        m_context.document, text,
        [&view = m_context.view](const Scenario* scenario) { view.setPreview(scenario); });
}

std::unique_ptr<MapTool> makeMapTool(MapToolKind kind, const MapToolContext& context)
{
    switch (kind) {
    case MapToolKind::Select:
        return std::make_unique<SelectTool>(context);
    case MapToolKind::Iceberg:
        return std::make_unique<IcebergTool>(context);
    case MapToolKind::Uav:
        return std::make_unique<UavTool>(context);
    case MapToolKind::Pan:
        return std::make_unique<PanTool>(context);
    }
    return nullptr;
}

QString moveText(const Scenario& scenario, std::span<const std::string> ids)
{
    const auto icebergs = std::count_if(ids.begin(), ids.end(), [&](const std::string& id) {
        return findIceberg(scenario, id) != nullptr;
    });
    const auto others = static_cast<std::ptrdiff_t>(ids.size()) - icebergs;
    if (icebergs == 0)
        return MapTools::tr("Move UAV");
    if (others > 0)
        return MapTools::tr("Move %n objects", nullptr, static_cast<int>(ids.size()));
    if (icebergs == 1)
        return MapTools::tr("Move iceberg");
    return MapTools::tr("Move %n icebergs", nullptr, static_cast<int>(icebergs));
}

bool isDragDistance(const QPointF& from, const QPointF& to)
{
    return (to - from).manhattanLength() >= QApplication::startDragDistance();
}

QString bearingText(const Point& way_m)
{
    const double heading_deg = headingFromPsi(std::atan2(way_m.y(), way_m.x()));
    return u"%1°"_s.arg(static_cast<int>(std::lround(heading_deg)) % 360, 3, 10, QChar(u'0'));
}

} // namespace berg
