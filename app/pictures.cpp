#include "app/pictures.h"

#include "core/io/files/run_json.h"
#include "core/io/files/scenario_json.h"
#include "core/io/text/atomic_file.h"
#include "core/io/text/file_set.h"
#include "widgets/charts/chart_image.h"
#include "widgets/charts/mission_charts.h"
#include "widgets/map/paint/map_painter.h"
#include "widgets/map/picture/mission_picture.h"
#include "widgets/study/run_list.h"

#include <QBuffer>
#include <QDir>
#include <QImage>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

const QString kMap = u"map"_s;
const QString kZeta = u"zeta"_s;
const QString kSigma = u"sigma"_s;

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

NewFile pngFile(const QImage& image, const QString& path)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!image.save(&buffer, "PNG"))
        throw Error(ErrorCode::FileUnwritable, path.toStdString(), {IssueId::CannotMake});
    return {.path = QFile::encodeName(path).toStdString(), .content = bytes.toStdString()};
}

/** The appearances asked for, and what is appended to the names of their pictures. */
std::vector<std::pair<Theme, QString>> themesOf(PictureTheme theme)
{
    std::vector<std::pair<Theme, QString>> themes;
    if (theme != PictureTheme::Dark)
        themes.emplace_back(Theme::light(), QString());
    if (theme != PictureTheme::Light)
        themes.emplace_back(Theme::dark(), theme == PictureTheme::Both ? u"-dark"_s : QString());
    return themes;
}

QString pictureName(const QString& what, const QString& ending)
{
    return what + ending + u".png"_s;
}

} // namespace

Mission flownMission(const std::string& path)
{
    const std::string text = readFile(path);
    if (formatOf(text, path) == "bergwatch-run")
        return replayedMission(runFromJson(text, path), path);
    const Scenario scenario = scenarioFromJson(text, path);
    Mission mission(scenario);
    mission.advance(scenario.duration_s);
    return mission;
}

QStringList pictureNames(PictureTheme theme)
{
    QStringList names;
    for (const auto& [shown, ending] : themesOf(theme))
        for (const QString& what : {kMap, kZeta, kSigma})
            names << pictureName(what, ending);
    return names;
}

QStringList writePictures(const Mission& mission, const PictureOptions& options,
                          const QLocale& locale)
{
    if (!QDir().mkpath(options.folder))
        throw Error(ErrorCode::FileUnwritable, options.folder.toStdString(), {IssueId::CannotMake});
    const FlightRecord record = recordOf(mission);
    const MapPicture picture = missionPicture(record, locale);
    const TimeChartContent zeta = missionChart(ChartKind::Zeta, record, locale);
    const TimeChartContent sigma = missionChart(ChartKind::Sigma, record, locale);
    const QSize mapSize_px = options.size_px.value_or(kMapSize_px);
    const QSize chartSize_px = options.size_px.value_or(kChartSize_px);
    const double mapScale = layoutScale(mapSize_px, kMapLayout);
    const double chartScale = layoutScale(chartSize_px, kChartLayout);

    QStringList paths;
    std::vector<NewFile> files;
    for (const auto& [shown, ending] : themesOf(options.theme)) {
        const Theme& theme = shown;
        const auto add = [&, &end = ending](const QString& what, const QImage& image) {
            paths << QDir(options.folder).filePath(pictureName(what, end));
            files.push_back(pngFile(image, paths.back()));
        };
        add(kMap, mapImage(picture, {.theme = theme, .locale = locale}, mapSize_px, mapScale));
        add(kZeta, chartImage(zeta, theme, chartSize_px, chartScale));
        add(kSigma, chartImage(sigma, theme, chartSize_px, chartScale));
    }
    writeFileSet(files);
    return paths;
}

} // namespace berg
