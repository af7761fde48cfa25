#include "app/pictures.h"

#include "core/io/atomic_file.h"
#include "core/io/run_json.h"
#include "core/io/scenario_json.h"
#include "widgets/charts/chart_image.h"
#include "widgets/charts/mission_charts.h"
#include "widgets/map/map_painter.h"
#include "widgets/map/mission_picture.h"

#include <QBuffer>
#include <QDir>
#include <QImage>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr QSize kMapSize_px{1600, 1000};
constexpr QSize kChartSize_px{1600, 700};

/**
 * Device pixels for each unit of the layout. Pictures are mostly looked at smaller than they are,
 * so symbols and type grow with the picture from this size on.
 */
constexpr QSizeF kMapLayout{1120, 700};
constexpr QSizeF kChartLayout{1120, 490};

double layoutScale(const QSize& size_px, const QSizeF& layout)
{
    return std::max(1.0,
                    std::min(size_px.width() / layout.width(), size_px.height() / layout.height()));
}

void writePng(const QImage& image, const QString& path)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!image.save(&buffer, "PNG"))
        throw Error(ErrorCode::FileUnwritable, path.toStdString(), "the picture is not encodable");
    writeFileAtomically(QFile::encodeName(path).toStdString(),
                        {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

/** Flies the run again with a record to draw from, and checks that it comes out as it did. */
Mission replayedRun(const RunFile& run, const std::string& path)
{
    RunFile recorded = run;
    recorded.options.record = true;
    Mission mission = replay(recorded, {}, {});
    RunFile flown = runOf(mission);
    if (!run.options.record) {
        flown.options.record = false;
        flown.keyframes.clear();
    }
    if (const std::vector<Issue> differences = compareRun(run, flown); !differences.empty())
        throw Error(ErrorCode::ReplayMismatch, path, differences);
    return mission;
}

} // namespace

Mission flownMission(const std::string& path)
{
    const std::string text = readFile(path);
    if (formatOf(text, path) == "bergwatch-run")
        return replayedRun(runFromJson(text, path), path);
    const Scenario scenario = scenarioFromJson(text, path);
    Mission mission(scenario);
    mission.advance(scenario.duration_s);
    return mission;
}

QStringList writePictures(const Mission& mission, const PictureOptions& options,
                          const QLocale& locale)
{
    if (!QDir().mkpath(options.folder))
        throw Error(ErrorCode::FileUnwritable, options.folder.toStdString(),
                    "the folder cannot be made");
    std::vector<Theme> themes;
    if (options.theme != PictureTheme::Dark)
        themes.push_back(Theme::light());
    if (options.theme != PictureTheme::Light)
        themes.push_back(Theme::dark());

    const FlightRecord record = recordOf(mission);
    const MapPicture picture = missionPicture(record, locale);
    const TimeChartContent zeta = zetaContent(record, locale);
    const TimeChartContent sigma = sigmaContent(record, locale);
    const QSize mapSize_px = options.size_px.value_or(kMapSize_px);
    const QSize chartSize_px = options.size_px.value_or(kChartSize_px);
    const double mapScale = layoutScale(mapSize_px, kMapLayout);
    const double chartScale = layoutScale(chartSize_px, kChartLayout);

    QStringList paths;
    for (const Theme& theme : themes) {
        const bool named = options.theme == PictureTheme::Both && theme.isDark;
        const auto write = [&](const QString& name, const QImage& image) {
            const QString path =
                QDir(options.folder).filePath(name + (named ? u"-dark.png"_s : u".png"_s));
            writePng(image, path);
            paths << path;
        };
        write(u"map"_s,
              mapImage(picture, {.theme = theme, .locale = locale}, mapSize_px, mapScale));
        write(u"zeta"_s, chartImage(zeta, theme, chartSize_px, chartScale));
        write(u"sigma"_s, chartImage(sigma, theme, chartSize_px, chartScale));
    }
    return paths;
}

} // namespace berg
