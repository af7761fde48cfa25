#include "widgets/print/export_painter.h"

#include "widgets/print/chart_page.h"
#include "widgets/print/flight_brief.h"
#include "widgets/print/log_page.h"
#include "widgets/print/map_page.h"

#include <stdexcept>

namespace berg {
namespace {

constexpr double kPreviewScale = 1.5; // sharp when most of a page is visible

} // namespace

PicturePage exportPage(const ExportFormat& format, const ExportContent& content,
                       const QLocale& locale)
{
    if (format.id == "brief")
        return flightBrief(content, locale);
    if (format.id.starts_with("map-"))
        return mapPage(content, locale);
    if (format.id == "log")
        return logPage(content, locale);
    if (format.id.starts_with("charts-"))
        return chartPage(content, locale);
    throw std::logic_error("exportPage: no page for " + std::string(format.id));
}

ExportPaint exportPaint(const QLocale& locale)
{
    const auto endingOf = [](const ExportFormat& format) {
        return QLatin1StringView(format.extension.data(), qsizetype(format.extension.size()));
    };
    return {.file =
                [=](const ExportFormat& format, const ExportContent& content) {
                    return pictureFile(exportPage(format, content, locale), endingOf(format));
                },
            .prepare =
                [=](const ExportFormat& format, const ExportContent& content) {
                    const auto page =
                        std::make_shared<const PicturePage>(exportPage(format, content, locale));
                    return ExportPainting{
                        .file = [page,
                                 ending = endingOf(format)] { return pictureFile(*page, ending); },
                        .image = [page] { return pictureImage(*page, kPreviewScale); }};
                }};
}

} // namespace berg
