#include "widgets/print/export_painter.h"

#include "widgets/print/chart_page.h"
#include "widgets/print/flight_brief.h"
#include "widgets/print/map_page.h"

#include <stdexcept>

namespace berg {
namespace {

constexpr double kLookScale = 1.5; // sharp where there is room for most of a page

} // namespace

PicturePage exportPage(const ExportFormat& format, const ExportContent& content,
                       const QLocale& locale)
{
    if (format.id == "brief")
        return flightBrief(content, locale);
    if (format.id.starts_with("map-"))
        return mapPage(content, locale);
    if (format.id.starts_with("charts-"))
        return chartPage(content, locale);
    throw std::logic_error("exportPage: no page for " + std::string(format.id));
}

ExportPaint exportPaint(const QLocale& locale)
{
    return {.file =
                [locale](const ExportFormat& format, const ExportContent& content) {
                    const QLatin1StringView ending(format.extension.data(),
                                                   qsizetype(format.extension.size()));
                    return pictureFile(exportPage(format, content, locale), ending);
                },
            .look =
                [locale](const ExportFormat& format, const ExportContent& content) {
                    return pictureImage(exportPage(format, content, locale), kLookScale);
                }};
}

} // namespace berg
