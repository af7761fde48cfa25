#include "app/start/start_content.h"

#include "core/io/files/run_json.h"
#include "core/io/files/scenario_json.h"
#include "core/io/text/atomic_file.h"
#include "core/mission/mission.h"
#include "widgets/map/paint/map_painter.h"
#include "widgets/map/picture/scenario_picture.h"
#include "widgets/tasks/work_failure.h"
#include "widgets/theme/palette.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

/** Device-independent pixels for each unit of the layout: the small picture of a larger map. */
constexpr double kReduction = 0.5;

/** Distance below which symbols would overlap. */
void paintDots(QPainter& painter, const MapFrame& frame)
{
    constexpr double kRadius_px = 5;
    constexpr double kSmallRadius_px = 3.5; // of many
    constexpr std::size_t kMany = 20;
    const MapPicture& picture = frame.picture;
    const Theme& theme = frame.style.theme;
    const double radius_px = picture.icebergs.size() > kMany ? kSmallRadius_px : kRadius_px;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme.sea, 1));
    const auto dot = [&](const Point& at_m, const QColor& colour) {
        painter.setBrush(colour);
        painter.drawEllipse(frame.layout.view.toPixel(at_m), radius_px, radius_px);
    };
    for (const MapIceberg& iceberg : picture.icebergs)
        dot(iceberg.position_m, theme.sigma.colour(iceberg.sigma_m2, picture.sigmaFull_m2));
    for (const MapUav& uav : picture.uavs)
        dot(uav.position_m, uavColour(theme, uav.place));
}

QImage painted(const MapPicture& picture, const Theme& theme, const QSize& size_px,
               double pixelRatio, bool asDots = false)
{
    const MapStyle style{.theme = theme, .locale = QLocale()};
    const QRectF rect(QPointF(0, 0), QSizeF(size_px) / kReduction);
    const MapLayout layout = arrangeMap(picture, style, rect);
    const Graticule graticule = graticuleOf(LocalFrame(picture.origin), layout.view, layout.rect);
    const MapFrame frame{
        .picture = picture, .style = style, .layout = layout, .graticule = graticule};

    QImage image(size_px * pixelRatio, QImage::Format_RGB32);
    image.setDevicePixelRatio(pixelRatio);
    QPainter painter(&image);
    painter.scale(kReduction, kReduction);
    paintMapGround(painter, frame);
    if (asDots)
        paintDots(painter, frame);
    else
        paintMapContent(painter, frame);
    return image;
}

/** The map of a planned scenario without its words; unplanned when stopped. */
QImage imageOf(const Scenario& scenario, const Theme& theme, double pixelRatio,
               const std::stop_token& stop)
{
    MapPicture picture = withScenario({}, scenario);
    const Plan answer = planFromStart(scenario, {.stop = stop});
    for (std::size_t uav = 0; uav < answer.uavs.size(); ++uav)
        for (const IcebergIndex iceberg : answer.uavs[uav].order) // all are shown, in their order
            picture.routes[uav].plan.push_back(MapPlace::of(iceberg.number()));
    return painted(picture, theme, kExampleImage_px, pixelRatio);
}

/** Returns the scenario that the file holds or its run was flown in; nullopt for studies. */
std::optional<Scenario> scenarioIn(const QFileInfo& file)
{
    const std::string path = QFile::encodeName(file.filePath()).toStdString();
    if (file.suffix() == u"berg"_s)
        return loadScenario(path, ScenarioUse::Editing);
    if (file.suffix() == u"bergrun"_s)
        return runFromJson(readFile(path), path).scenario;
    return std::nullopt;
}

/** Its image has no plan: that of a large scenario takes its time. */
RecentFile readRecentFile(const QString& path, const Theme& theme, double pixelRatio)
{
    const QFileInfo file(path);
    RecentFile recent{.path = path, .exists = file.exists(), .changed = file.lastModified()};
    if (!recent.exists)
        return recent;
    static_cast<void>(failureOf([&] { // opening the file reports the error
        const std::optional<Scenario> scenario = scenarioIn(file);
        if (!scenario)
            return;
        recent.icebergs = static_cast<int>(scenario->icebergs.size());
        recent.image =
            painted(withScenario({}, *scenario), theme, kRecentImage_px, pixelRatio, true);
    }));
    return recent;
}

Example paintedExample(const QString& path, const Theme& theme, double pixelRatio,
                       const std::stop_token& stop)
{
    const Scenario scenario = loadExample(path);
    return {.path = path,
            .title = QString::fromStdString(scenario.name),
            .notes = QString::fromStdString(scenario.notes),
            .icebergs = static_cast<int>(scenario.icebergs.size()),
            .image = imageOf(scenario, theme, pixelRatio, stop)};
}

} // namespace

QStringList examplePaths()
{
    return {u":/scenarios/disko-bay-4.berg"_s,
            u":/scenarios/recorded-drift.berg"_s,
            u":/scenarios/grand-banks-12.berg"_s,
            u":/scenarios/hibernia-asset.berg"_s,
            u":/scenarios/flemish-pass-appearing.berg"_s,
            u":/scenarios/barents-wind.berg"_s,
            u":/scenarios/bonavista-lost.berg"_s,
            u":/scenarios/upernavik-real-drift.berg"_s,
            u":/scenarios/baffin-bay-day.berg"_s,
            u":/scenarios/twillingate-clusters.berg"_s,
            u":/scenarios/fram-strait-endurance.berg"_s,
            u":/scenarios/jones-sound-late-plans.berg"_s,
            u":/scenarios/svalbard-two-uavs.berg"_s,
            u":/scenarios/melville-bay-three-uavs.berg"_s,
            u":/scenarios/labrador-20.berg"_s,
            u":/scenarios/scoresby-sund-40.berg"_s};
}

Scenario loadExample(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        throw Error(ErrorCode::FileNotFound, path.toStdString(), {IssueId::Missing});
    return scenarioFromJson(file.readAll().toStdString(), path.toStdString());
}

StartContent::StartContent(QObject* parent) : QObject(parent)
{
    m_reader.setMaxThreadCount(1);
    m_painter.setMaxThreadCount(1);
}

StartContent::~StartContent()
{
    m_stop.request_stop();
    for (QThreadPool* thread : {&m_reader, &m_painter}) {
        thread->clear();
        thread->waitForDone();
    }
}

void StartContent::finish()
{
    m_stop.request_stop();
    m_painter.clear();
    m_reader.clear();
    m_reader.start(
        [this] { QMetaObject::invokeMethod(this, &QObject::deleteLater, Qt::QueuedConnection); });
}

void StartContent::readRecent(const QStringList& paths, const Theme& theme, double pixelRatio)
{
    m_reader.start([this, paths, theme, pixelRatio] {
        QList<RecentFile> files;
        for (const QString& path : paths)
            files << readRecentFile(path, theme, pixelRatio);
        emit recentRead(files);
    });
}

void StartContent::paintExamples(const Theme& theme, double pixelRatio, const QStringList& paths)
{
    m_stop.request_stop();
    m_stop = std::stop_source();
    m_painter.clear();
    for (int place = 0; place < paths.size(); ++place)
        m_painter.start(
            [this, place, path = paths[place], theme, pixelRatio, stop = m_stop.get_token()] {
                // Only the picture is missing then; opening the example reports the error.
                static_cast<void>(failureOf([&] {
                    const Example example = paintedExample(path, theme, pixelRatio, stop);
                    if (!stop.stop_requested())
                        emit examplePainted(place, example, theme.sea);
                }));
            });
}

} // namespace berg
