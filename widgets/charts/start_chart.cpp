#include "widgets/charts/start_chart.h"

#include "core/io/study/start_figure.h"
#include "widgets/charts/figure_text.h"
#include "widgets/words/report_language.h"
#include "widgets/words/weather_words.h"

namespace berg {
namespace {

StartFigureFormat startFormat(const QLocale& locale)
{
    constexpr int kDigits = 4;
    return {.study = {.words = reportLanguage(),
                      .number = numberText(locale),
                      .zeta =
                          [locale](double zeta_m2s) {
                              return utf8(significantText(zeta_m2s, kDigits, locale));
                          },
                      .unit =
                          [](double largest_m2s) {
                              const ShownUnit unit = zetaUnit(largest_m2s);
                              return FigureUnit{.name = utf8(unit.name), .inSi = unit.inSi};
                          }},
            .reason = [locale](const WeatherReason& reason) {
                return utf8(weatherReasonText(reason, locale));
            }};
}

} // namespace

StartChart::StartChart(const Theme& theme, QWidget* parent) : FigureView(theme, parent)
{
    refresh();
}

void StartChart::setScan(const std::optional<StartScan>& scan, bool isWaiting)
{
    m_scan = scan;
    m_isWaiting = isWaiting;
    forgetItems(scan ? scan->starts.size() : 0);
    refresh();
}

Figure StartChart::figure() const
{
    if (m_scan)
        return startFigure(*m_scan, startFormat(locale()));
    Figure figure{.name = utf8(tr("Zeta by start time"))};
    figure.emptyText =
        utf8(m_isWaiting ? tr("Comparing…")
                         : tr("Press Compare to fly the scenario from each start time."));
    return figure;
}

} // namespace berg
