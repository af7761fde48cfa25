#include "core/base/angles.h"
#include "core/base/number_text.h"
#include "core/base/version.h"
#include "core/io/export/flight_log.h"
#include "core/io/figure/figure_svg.h"
#include "core/io/figure/report_style.h"
#include "core/io/text/html_text.h"
#include "core/io/words/event_words.h"
#include "core/tracking/position_error.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace berg {

namespace {

/** Time as "1:02:03". */
std::string clockOf(double time_s)
{
    const long long whole = std::llround(time_s);
    char text[48];
    std::snprintf(text, sizeof text, "%lld:%02lld:%02lld", whole / 3600, whole / 60 % 60,
                  whole % 60);
    return text;
}

std::string rounded(double value)
{
    return printedNumber(std::round(value), 0);
}

std::string distanceOf(double length_m)
{
    constexpr double kKilometre_m = 1000;
    return length_m < kKilometre_m ? rounded(length_m) + " m"
                                   : printedNumber(std::round(length_m / 100) / 10, 1) + " km";
}

/** Policy and tau, as "visitation, τ = 1.2". */
std::string plannerText(const PlannerSettings& settings)
{
    const std::string name = nameOf(kPolicyNames, settings.policy);
    return traitsOf(settings.policy).usesTau ? name + ", τ = " + numberText(settings.tau) : name;
}

LogFormat fileFormat(const ExportContent& content)
{
    const auto time = [start = content.start](double time_s) {
        return start ? utcText(*start, time_s) : clockOf(time_s);
    };
    const auto tenths = [](double value) { return printedNumber(std::round(value * 10) / 10, 1); };
    return {.start = time(0),
            .time = time,
            .date = time,
            .duration = clockOf,
            .distance = distanceOf,
            .zeta = [](double zeta_m2s) { return rounded(zeta_m2s) + " m²\u00a0s"; },
            .sigma = tenths,
            .radius = [tenths](double sigma_m2) { return tenths(radius95_m(sigma_m2)) + " m"; },
            .planner = plannerText,
            .number = printedNumber,
            .speed =
                [](double mps, int decimals) {
                    const double scale = std::pow(10.0, decimals);
                    return printedNumber(std::round(mps * scale) / scale, decimals) + " m/s";
                },
            .figure = [](const Figure& figure) { return figureSvg(figure, 760, 300); }};
}

/** Writes the parts of the page. */
class LogWriter
{
public:
    LogWriter(const ExportContent& content, const LogFormat& format)
        : m_content(content)
        , m_log(flightLog(content))
        , m_mission(*content.mission)
        , m_words(content.words)
        , m_format(format)
    {
    }

    [[nodiscard]] std::string facts() const
    {
        const auto fact = [this](std::string_view english, const std::string& value) {
            return HtmlFact{m_words.html(english), value};
        };
        const Scenario& scenario = m_mission.scenario();
        return factsHtml(
            {fact(QT_TRANSLATE_NOOP("Report", "Start"), m_format.start),
             fact(QT_TRANSLATE_NOOP("Report", "Until"), m_format.time(m_log.flown_s)),
             fact(QT_TRANSLATE_NOOP("Report", "Zeta flown"), m_format.zeta(m_log.metrics.zeta_m2s)),
             fact(QT_TRANSLATE_NOOP("Report", "Predicted before take-off"),
                  m_log.predicted ? m_format.zeta(m_log.predicted->mean_m2s) : "–"),
             fact(QT_TRANSLATE_NOOP("Report", "Visits"), std::to_string(m_log.metrics.visits)),
             fact(QT_TRANSLATE_NOOP("Report", "Plans made"), std::to_string(m_log.metrics.replans)),
             fact(QT_TRANSLATE_NOOP("Report", "Planned by"), m_format.planner(scenario.planner)),
             fact(QT_TRANSLATE_NOOP("Report", "Seed"), std::to_string(scenario.seed)),
             fact(QT_TRANSLATE_NOOP("Report", "Program"), htmlText(programName()))},
            3);
    }

    [[nodiscard]] std::string uavs() const
    {
        std::vector<std::string_view> heads{
            QT_TRANSLATE_NOOP("Report", "UAV"),   QT_TRANSLATE_NOOP("Report", "Visits planned"),
            QT_TRANSLATE_NOOP("Report", "flown"), QT_TRANSLATE_NOOP("Report", "Distance planned"),
            QT_TRANSLATE_NOOP("Report", "flown"), QT_TRANSLATE_NOOP("Report", "Time planned"),
            QT_TRANSLATE_NOOP("Report", "aloft"), QT_TRANSLATE_NOOP("Report", "Took off"),
            QT_TRANSLATE_NOOP("Report", "Landed")};
        if (m_content.operation)
            heads.emplace_back(QT_TRANSLATE_NOOP("Report", "Outside the flight geography"));
        HtmlTable table(m_words.html(QT_TRANSLATE_NOOP(
                            "Report", "Planned: the first sortie of the plan before take-off, over "
                                      "ground in straight legs. Distances flown are through the "
                                      "air.")),
                        m_words.heads(heads));
        for (const LogUav& uav : m_log.uavs) {
            std::vector<std::string> cells{nameOf(uav),
                                           std::to_string(uav.plannedVisits),
                                           std::to_string(uav.visits),
                                           m_format.distance(uav.plannedLength_m),
                                           m_format.distance(uav.flown_m),
                                           m_format.duration(uav.plannedTime_s),
                                           m_format.duration(uav.aloft_s),
                                           timeOr(uav.tookOff_s, "–"),
                                           timeOr(uav.landed_s, "–")};
            if (m_content.operation)
                cells.push_back(m_format.duration(uav.outside_s));
            table.addRow(cells);
        }
        return heading(QT_TRANSLATE_NOOP("Report", "Planned and flown")) + table.html();
    }

    [[nodiscard]] std::string figure() const
    {
        if (m_mission.recorder().samples().size() < 2)
            return {};
        return heading(QT_TRANSLATE_NOOP("Report", "ζ over time")) + "<figure>\n" +
               m_format.figure(zetaFigure()) + "</figure>\n";
    }

    [[nodiscard]] std::string sightings() const
    {
        HtmlTable table(
            m_words.html(QT_TRANSLATE_NOOP(
                "Report", "Longest unseen: from when an iceberg was known of, or seen, "
                          "until it was seen again, left, was removed or the record ends.")),
            m_words.heads(
                {QT_TRANSLATE_NOOP("Report", "Iceberg"), QT_TRANSLATE_NOOP("Report", "First seen"),
                 QT_TRANSLATE_NOOP("Report", "Last seen"), QT_TRANSLATE_NOOP("Report", "Visits"),
                 QT_TRANSLATE_NOOP("Report", "Longest unseen"),
                 QT_TRANSLATE_NOOP("Report", "σ at the end, m²"),
                 QT_TRANSLATE_NOOP("Report", "95 % within")}));
        const std::string never = m_words.html(QT_TRANSLATE_NOOP("Report", "never"));
        for (const LogIceberg& iceberg : m_log.icebergs)
            table.addRow({htmlName(titleOf(m_mission.icebergs()[toIndex(iceberg.iceberg)])),
                          timeOr(iceberg.first_s, never), timeOr(iceberg.last_s, never),
                          std::to_string(iceberg.visits),
                          m_format.duration(iceberg.longestUnseen_s),
                          m_format.sigma(iceberg.sigma_m2), m_format.radius(iceberg.sigma_m2)});
        return heading(QT_TRANSLATE_NOOP("Report", "Sightings")) + table.html();
    }

    [[nodiscard]] std::string deviations() const
    {
        constexpr std::size_t kMostListed = 200;
        std::string lines;
        const auto line = [&lines](const std::string& text) { lines += "<li>" + text + "</li>\n"; };
        if (m_log.wasChanged)
            line(m_words.html(QT_TRANSLATE_NOOP("Report", "Something was changed in flight: the "
                                                          "prediction was for another flight.")));
        for (std::size_t i = 0; i < std::min(m_log.deviations.size(), kMostListed); ++i)
            line(sentenceOf(m_log.deviations[i]));
        if (m_log.deviations.size() > kMostListed)
            line(m_words.html(QT_TRANSLATE_NOOP("Report", "and %1 more"),
                              {std::to_string(m_log.deviations.size() - kMostListed)}));
        return heading(QT_TRANSLATE_NOOP("Report", "Deviations")) +
               (lines.empty()
                    ? "<p>" + m_words.html(QT_TRANSLATE_NOOP("Report", "None on record.")) +
                          "</p>\n"
                    : "<ul class=\"findings\">\n" + lines + "</ul>\n");
    }

    [[nodiscard]] std::string forecast() const
    {
        if (!m_log.forecast)
            return {};
        const LogForecast& forecast = *m_log.forecast;
        const std::string unknown = m_words.html(QT_TRANSLATE_NOOP("Report", "unknown"));
        const auto fact = [this](std::string_view english, const std::string& value) {
            return HtmlFact{m_words.html(english), value};
        };
        std::string html = factsHtml(
            {fact(QT_TRANSLATE_NOOP("Report", "Source"),
                  forecast.source.empty() ? unknown : htmlName(forecast.source)),
             fact(QT_TRANSLATE_NOOP("Report", "Issued"),
                  forecast.issued_s ? m_format.date(*forecast.issued_s) : unknown),
             fact(QT_TRANSLATE_NOOP("Report", "Age at take-off"),
                  forecast.ageAtTakeOff_h
                      ? m_format.number(std::round(*forecast.ageAtTakeOff_h * 10) / 10, 1) + " h"
                      : unknown)},
            3);
        HtmlTable table(
            m_words.html(QT_TRANSLATE_NOOP("Report", "Used in flight, at the middle of the starts "
                                                     "of the UAVs.")),
            m_words.heads({QT_TRANSLATE_NOOP("Report", "Time"),
                           QT_TRANSLATE_NOOP("Report", "Wind, true"),
                           QT_TRANSLATE_NOOP("Report", "Gusts"),
                           QT_TRANSLATE_NOOP("Report", "Current, true")}));
        for (const LogWeather* weather : {&forecast.start, &forecast.end})
            table.addRow({m_format.time(weather->time_s), wind(weather->wind_mps),
                          weather->gust_mps ? m_format.speed(*weather->gust_mps, 1) : "–",
                          current(weather->current_mps)});
        std::string gaps;
        for (const LogGap& gap : forecast.gaps)
            gaps += "<li>" +
                    m_words.html(
                        gap.quantity == ForecastQuantity::Wind
                            ? QT_TRANSLATE_NOOP("Report", "The forecast has no wind between %1 and "
                                                          "%2: the flight used the constant wind "
                                                          "of the scenario.")
                            : QT_TRANSLATE_NOOP("Report", "The forecast has no current between %1 "
                                                          "and %2: the flight used the constant "
                                                          "current of the scenario."),
                        {m_format.time(gap.from_s), m_format.time(gap.to_s)}) +
                    "</li>\n";
        return heading(QT_TRANSLATE_NOOP("Report", "Forecast")) + html + table.html() +
               (gaps.empty() ? gaps : "<ul class=\"findings\">\n" + gaps + "</ul>\n");
    }

    [[nodiscard]] std::string hashes() const
    {
        std::string html =
            "<p class=\"muted\">" +
            m_words.html(QT_TRANSLATE_NOOP(
                "Report", "SHA-256 of the first plan as a file of the format wpl:")) +
            "</p>\n";
        for (const LogUav& uav : m_log.uavs)
            html += "<p><code>" + uav.planHash + "</code> " + nameOf(uav) + "</p>\n";
        return html;
    }

private:
    [[nodiscard]] std::string heading(std::string_view english) const
    {
        return "<h2>" + m_words.html(english) + "</h2>\n";
    }

    /** Direction of a velocity as "045°". */
    [[nodiscard]] static std::string bearing(const Point& velocity_mps)
    {
        const double turn_deg = degFromRad(std::atan2(velocity_mps.x(), velocity_mps.y()));
        char text[16];
        std::snprintf(text, sizeof text, "%03lld°", (std::llround(turn_deg) + 360) % 360);
        return text;
    }

    [[nodiscard]] std::string wind(const Point& wind_mps) const
    {
        if (wind_mps.isZero(0))
            return m_words.html(QT_TRANSLATE_NOOP("Report", "No wind"));
        return m_words.html(QT_TRANSLATE_NOOP("Report", "%1 from %2"),
                            {m_format.speed(wind_mps.norm(), 1), bearing(-wind_mps)});
    }

    [[nodiscard]] std::string current(const Point& current_mps) const
    {
        if (current_mps.isZero(0))
            return "–";
        return m_words.html(QT_TRANSLATE_NOOP("Report", "%1 towards %2"),
                            {m_format.speed(current_mps.norm(), 2), bearing(current_mps)});
    }

    [[nodiscard]] std::string nameOf(const LogUav& uav) const
    {
        return htmlName(titleOf(m_mission.scenario().uavs[uav.row]));
    }

    [[nodiscard]] std::string timeOr(const std::optional<double>& time_s,
                                     const std::string& missing) const
    {
        return time_s ? m_format.time(*time_s) : missing;
    }

    /** Zeta and the sum of sigma, whose integral it is, with a tick for each visit. */
    [[nodiscard]] Figure zetaFigure() const
    {
        const std::vector<Sample>& samples = m_mission.recorder().samples();
        constexpr std::size_t kMostPoints = 400;
        const std::size_t stride = samples.size() / kMostPoints + 1;
        PlotLine sum{.points = {}, .ink = {.of = InkOf::Plan}, .width_px = 1.4, .key = "sum"};
        PlotLine zeta{.points = {},
                      .ink = {.of = InkOf::Text},
                      .width_px = 2,
                      .onRightAxis = true,
                      .key = "mean"};
        double most_m2 = 1;
        const auto add = [&](const Sample& sample) {
            sum.points.push_back({.x = sample.time_s, .y = sample.sigmaSum_m2});
            zeta.points.push_back({.x = sample.time_s, .y = sample.zeta_m2s});
            most_m2 = std::max(most_m2, sample.sigmaSum_m2);
        };
        for (std::size_t i = 0; i < samples.size(); i += stride)
            add(samples[i]);
        add(samples.back());
        Figure figure{
            .name = m_words.text(QT_TRANSLATE_NOOP("Report", "Zeta over time")),
            .title = {},
            .emptyText = {},
            .leftTitles = {m_words.text(QT_TRANSLATE_NOOP("Report", "Sum of σ, m²"))},
            .rightTitles = {"ζ, m² s"},
            .leftInk = sum.ink,
            .rightInk = zeta.ink,
            .x = {.ends = AxisEnds::Exact,
                  .least = 0,
                  .largest = samples.back().time_s,
                  .spacing_px = 90,
                  .text = [duration = m_format.duration](double time_s,
                                                         int) { return duration(time_s); },
                  .title = m_words.text(QT_TRANSLATE_NOOP("Report", "Time since the start")),
                  .isTime = true},
            .y = axisTo(most_m2),
            .right = axisTo(std::max(1.0, samples.back().zeta_m2s)),
            .markKey = m_words.text(QT_TRANSLATE_NOOP("Report", "iceberg reached")),
            .areas = {},
            .lines = {sum, zeta},
            .marks = {},
            .labels = {},
            .items = {},
            .description =
                m_words.text(QT_TRANSLATE_NOOP("Report", "Zeta over time, in the end %1."),
                             {m_format.zeta(m_log.metrics.zeta_m2s)})};
        for (const MissionEvent& event : m_mission.events())
            if (event.kind == EventKind::Reached)
                figure.lines.push_back(
                    {.points = {{event.time_s, -kPlotEdge, 0, -6}, {event.time_s, -kPlotEdge}},
                     .ink = {.of = InkOf::Uav}});
        return figure;
    }

    [[nodiscard]] PlotAxis axisTo(double largest) const
    {
        return {.ends = AxisEnds::Around0,
                .least = 0,
                .largest = largest,
                .spacing_px = 40,
                .text = m_format.number};
    }

    [[nodiscard]] std::string sentenceOf(const MissionEvent& event) const
    {
        const auto name = [](const auto& all, const auto& index) {
            return index && toIndex(*index) < all.size() ? htmlName(titleOf(all[toIndex(*index)]))
                                                         : std::string();
        };
        const std::vector<Uav>& uavs = m_mission.scenario().uavs;
        const EventNames names{.iceberg = name(m_mission.icebergs(), event.iceberg),
                               .uav = uavs.size() > 1 ? name(uavs, event.uav) : std::string(),
                               .otherUav = name(uavs, event.otherUav),
                               .distance = m_format.distance(event.distance_m),
                               .entry = m_format.duration(event.entry_s),
                               .planner =
                                   m_format.planner({.policy = event.policy, .tau = event.tau})};
        std::string text = m_format.time(event.time_s) + ' ' +
                           eventSentence(event, names, [this](std::string_view english) {
                               return htmlText(m_words.translated(english));
                           });
        if (!event.failure.empty())
            text += ": " + htmlText(event.failure);
        return text;
    }

    const ExportContent& m_content;
    FlightLog m_log; ///< first, as it throws without a mission
    const Mission& m_mission;
    const ReportWords& m_words;
    const LogFormat& m_format;
};

} // namespace

LogPage logPage(const ExportContent& content, const LogFormat& format)
{
    const LogWriter log(content, format);
    return {.title = content.words.text(
                QT_TRANSLATE_NOOP("Report", "Flight log: %1"),
                {content.name.empty() ? std::string("Bergwatch") : content.name}),
            .summary = log.facts() + log.uavs(),
            .figure = log.figure(),
            .details = log.forecast() + log.sightings() + log.deviations() + log.hashes()};
}

std::string flightLogHtml(const ExportContent& content)
{
    const LogPage page = logPage(content, fileFormat(content));
    return reportHead(
               {.title = page.title, .program = programName(), .language = content.words.tag()}) +
           "<body>\n<header>\n<h1>" + htmlName(page.title) + "</h1>\n</header>\n<main>\n" +
           page.summary + page.figure + page.details + "</main>\n</body>\n</html>\n";
}

} // namespace berg
