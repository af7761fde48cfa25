#include "widgets/print/operation_page.h"

#include "core/io/text/html_text.h"
#include "widgets/print/brief_html.h"
#include "widgets/print/flight_brief.h"
#include "widgets/print/page_text.h"
#include "widgets/print/printable_text.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct OperationPage
{
    Q_DECLARE_TR_FUNCTIONS(OperationPage)
};

constexpr int kMostLines = 4;        // of a text
constexpr int kBlankLines = 2;       // of an entry filled in by hand
constexpr int kBlankItems = 6;       // of a checklist
constexpr qsizetype kMostItems = 60; // more do not fit

QString metres(double length_m, const QLocale& locale)
{
    return distanceText(std::round(length_m), locale, 3, DistanceUnit::Metric);
}

std::vector<HtmlFact> volumeFacts(const OperationVolume& volume, const QLocale& locale)
{
    const auto fact = [](const QString& caption, const QString& value) {
        return HtmlFact{html(caption), html(value)};
    };
    return {fact(OperationPage::tr("Largest speed over ground"),
                 speedText(volume.speed_mps, locale, 3)),
            fact(OperationPage::tr("Flight geography, height"),
                 heightText(std::round(volume.height_m), locale)),
            fact(OperationPage::tr("Contingency volume, height"),
                 heightText(std::round(volume.ceiling_m), locale)),
            fact(OperationPage::tr("Contingency volume, width"), metres(volume.outside_m, locale)),
            fact(OperationPage::tr("Ground-risk buffer, width"), metres(volume.buffer_m, locale)),
            fact(OperationPage::tr("Adjacent area, width"), metres(volume.adjacent_m, locale))};
}

/** Formulas with values inserted. */
QStringList formulasOf(const Scenario& scenario, const OperationVolume& volume,
                       const QLocale& locale)
{
    const Operation& o = *scenario.operation;
    const auto number = [&](double value) {
        return std::abs(value) < 1000 ? locale.toString(value, 'g', 4)
                                      : fixedText(value, 0, locale);
    };
    return {
        scenario.geofence
            ? OperationPage::tr("Flight geography: inside the geofence.")
            : OperationPage::tr("Flight geography: all places that a plan may reach, plus a margin "
                                "of %1 m.")
                  .arg(number(o.margin_m)),
        u"S_CV = %1 + %2 + %3 + v · %4 s + v²/(g tan %5°) = %6 m"_s.arg(
            number(o.positionError_m), number(o.pathError_m), number(o.mapError_m),
            number(o.reaction_s), number(o.turnBank_deg), number(volume.outside_m)),
        u"H_CV = %1 + %2 + %3 v · %4 s + %5 v²/g = %6 m"_s.arg(
            number(volume.height_m), number(o.heightError_m), number(o.climbPart),
            number(o.reaction_s), number(o.pullUpPart), number(volume.ceiling_m)),
        u"S_GRB = %1 · H_CV + %2/2 = %3 m"_s.arg(number(o.bufferRatio), number(o.span_m),
                                                 number(volume.buffer_m)),
        u"S_AA = v · %1 s, %2 … %3 m = %4 m"_s.arg(number(o.adjacent_s), number(o.adjacentLeast_m),
                                                   number(o.adjacentMost_m),
                                                   number(volume.adjacent_m)),
        OperationPage::tr("Formulas and default constants: Digisky calculator 3.3.0, based on the "
                          "guide of the Swiss FOCA; not an authority's own text."),
        OperationPage::tr("The outlines are in the KML, KMZ and GeoJSON exports.")};
}

QString limitText(const std::optional<double>& speed_mps, const QLocale& locale)
{
    return speed_mps ? speedText(*speed_mps, locale, 3) : u"–"_s;
}

/** Adds the limits that a forecast is compared with, if a UAV has one. */
void addForecastLimits(std::vector<QStringList>& rows, const ExportContent& content,
                       const QLocale& locale)
{
    const auto limitsOf = [&content](const ExportUav& uav) -> const WeatherLimits& {
        return content.scenario->uavs[uav.row].weather;
    };
    if (std::ranges::none_of(content.uavs, [&](const ExportUav& uav) {
            return limitsOf(uav).visibility_m || limitsOf(uav).ceiling_m;
        }))
        return;
    rows.front() << OperationPage::tr("Visibility limit") << OperationPage::tr("Ceiling limit");
    for (std::size_t i = 0; i < content.uavs.size(); ++i) {
        const WeatherLimits& limits = limitsOf(content.uavs[i]);
        rows[i + 1] << (limits.visibility_m ? distanceText(*limits.visibility_m, locale) : u"–"_s)
                    << (limits.ceiling_m ? heightText(*limits.ceiling_m, locale) : u"–"_s);
    }
}

std::vector<QStringList> uavRows(const ExportContent& content, const QLocale& locale)
{
    std::vector<QStringList> rows{{OperationPage::tr("UAV"), OperationPage::tr("Endurance"),
                                   OperationPage::tr("Reserve"), OperationPage::tr("Wind limit"),
                                   OperationPage::tr("Gust limit"),
                                   OperationPage::tr("Icing conditions")}};
    for (const ExportUav& uav : content.uavs) {
        const Uav& entered = content.scenario->uavs[uav.row];
        const bool isLimited = entered.spec.endurance_s > 0;
        rows.push_back({printable(titleOf(entered)),
                        isLimited ? clockText(entered.spec.endurance_s) : u"–"_s,
                        isLimited ? clockText(reserve_s(entered.spec)) : u"–"_s,
                        limitText(entered.weather.wind_mps, locale),
                        limitText(entered.weather.gust_mps, locale),
                        entered.weather.icing ? OperationPage::tr("flown in")
                                              : OperationPage::tr("not flown in")});
    }
    addForecastLimits(rows, content, locale);
    return rows;
}

/** Lines for handwriting, each after `mark`. */
std::string blankHtml(int lines, const std::string& mark)
{
    std::string html = "<table class=\"blank\" width=\"100%\">";
    for (int i = 0; i < lines; ++i)
        html += "<tr><td>" + mark + "</td></tr>";
    return html + "</table>\n";
}

const std::string kCheckBox = "\u2610";

QStringList linesOf(const std::string& utf8)
{
    QStringList lines;
    for (const QString& line : QString::fromStdString(utf8).split(u'\n', Qt::SkipEmptyParts))
        lines << printable(line.toStdString());
    return lines;
}

/** Joins lines to one paragraph, separated by dots. */
QString oneParagraph(const std::string& utf8)
{
    return linesOf(utf8).join(u" \u00b7 "_s);
}

/** Writes the page with so many items of the checklist. */
std::string operationHtml(const ExportContent& content, const QLocale& locale, double width_px,
                          qsizetype mostItems)
{
    const Operation& operation = *content.scenario->operation;
    const auto text = [width_px](const QString& words) {
        constexpr double kLine = 0.9; // part of a line that words fill at least
        return htmlWithin(words, kLine * kMostLines * width_px);
    };
    std::string page =
        "<h1>" +
        html(OperationPage::tr("Operation volume: proposal, to be checked with your authority")) +
        "</h1>\n<p>" + text(pageTitle(content)) + "</p>\n<hr/>\n" +
        factsHtml(volumeFacts(*content.operation, locale), 3);
    for (const QString& formula : formulasOf(*content.scenario, *content.operation, locale))
        page += "<p>" + text(formula) + "</p>\n";
    page += "<p></p>\n" + uavTableHtml(uavRows(content, locale), width_px);
    for (const auto& [caption, words] : std::initializer_list<std::pair<QString, QString>>{
             {OperationPage::tr("Crew"), oneParagraph(operation.crew)},
             {OperationPage::tr("Call sign"), printable(operation.callSign)},
             {OperationPage::tr("Contacts"), oneParagraph(operation.contacts)},
             {OperationPage::tr("Command link"), oneParagraph(operation.link)},
             {OperationPage::tr("Date and signatures"), {}}})
        page +=
            "<p class=\"item\"><span class=\"muted\">" + html(caption) + "</span></p>\n" +
            (words.isEmpty() ? blankHtml(kBlankLines, "&#160;") : "<p>" + text(words) + "</p>\n");
    page += "<h2>" + html(OperationPage::tr("Checklist")) + "</h2>\n";
    const QStringList items = linesOf(operation.checklist);
    if (items.isEmpty())
        page += blankHtml(kBlankItems, kCheckBox);
    for (const QString& item : items.first(std::min(items.size(), mostItems)))
        page += "<p class=\"item\">" + kCheckBox + ' ' + text(item) + "</p>\n";
    if (items.size() > mostItems)
        page +=
            "<p>" + html(OperationPage::tr("and %1 more").arg(items.size() - mostItems)) + "</p>\n";
    return page + "<p class=\"foot\">" +
           html(OperationPage::tr("Made by Bergwatch from the scenario. It does not imply that the "
                                  "operation may be flown.")) +
           "</p>\n";
}

} // namespace

PrintedDocument operationDocument(const ExportContent& content, const QLocale& locale)
{
    PrintedDocument document{.paper_px = briefPage_px(locale)};
    for (qsizetype items = kMostItems; items >= 0; --items) {
        document.html = operationHtml(content, locale, document.room_px().width(), items);
        if (PrintedText(document).pageCount() == 1)
            break;
    }
    return document;
}

} // namespace berg
