#pragma once

#include "widgets/charts/time_chart.h"

#include <QImage>

#include <array>
#include <functional>

namespace berg {

/** The chart as an image of `size_px`; `scale` device pixels for each unit of the layout. */
[[nodiscard]] QImage chartImage(const TimeChartContent& content, const Theme& theme,
                                const QSize& size_px, double scale);

/** Ends of the names of picture files a chart can be written to. */
inline constexpr std::array kChartPictureEndings = {"png", "svg", "pdf"};

/** A stretch of a chart on a page. */
struct ChartPage
{
    QSize size_px{1120, 490};         ///< of the layout, at 96 to the inch; PNG has twice as many
    std::optional<TimeWindow> window; ///< none: everything
};

/**
 * Writes the chart as the picture that the end of `path` names. Throws `Error`: Unsupported for
 * another end than `kChartPictureEndings`, FileUnwritable.
 */
void writeChartPicture(const TimeChartContent& content, const Theme& theme, const ChartPage& page,
                       const QString& path);

/** A picture on a page of its own. */
struct PicturePage
{
    QSize size_px; ///< of the layout, at 96 to the inch; PNG has twice as many
    QString title;
    QString description;
    std::function<void(QPainter&)> paint; ///< within `size_px`
};

/** As `writeChartPicture` for whatever can be painted. Throws likewise. */
void writePicture(const PicturePage& page, const QString& path);

} // namespace berg
