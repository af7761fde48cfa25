#include "widgets/print/operation_page.h"

#include "widgets/print/brief_setting.h"
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

constexpr BriefType kHeading{.size_px = 11, .isBold = true};
constexpr BriefType kWords{.size_px = 11};

constexpr double kGap_px = 9;
constexpr double kBlankLine_px = 24; ///< to write on
constexpr int kBlankLines = 2;       ///< of what is filled in by hand
constexpr int kMostLines = 4;        ///< of a text
constexpr double kBox_px = 9;

QString metres(double length_m, const QLocale& locale)
{
    return distanceText(std::round(length_m), locale, 3, DistanceUnit::Metric);
}

std::vector<BriefFact> volumeFacts(const OperationVolume& volume, const QLocale& locale)
{
    return {
        {OperationPage::tr("Largest speed over ground"), speedText(volume.speed_mps, locale, 3)},
        {OperationPage::tr("Flight geography, height"),
         heightText(std::round(volume.height_m), locale)},
        {OperationPage::tr("Contingency volume, height"),
         heightText(std::round(volume.ceiling_m), locale)},
        {OperationPage::tr("Contingency volume, width"), metres(volume.outside_m, locale)},
        {OperationPage::tr("Ground-risk buffer, width"), metres(volume.buffer_m, locale)},
        {OperationPage::tr("Adjacent area, width"), metres(volume.adjacent_m, locale)}};
}

/** With the numbers put in. */
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
            ? OperationPage::tr("Flight geography: inside of the geofence.")
            : OperationPage::tr("Flight geography: all places that a plan may lead to, and %1 m "
                                "round them.")
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
        OperationPage::tr("Formulas and usual constants: calculator of Digisky 3.3.0, after the "
                          "guide of the Swiss FOCA; not an authority's own text."),
        OperationPage::tr("The outlines are in the KML, KMZ and GeoJSON exports.")};
}

QString limitText(const std::optional<double>& speed_mps, const QLocale& locale)
{
    return speed_mps ? speedText(*speed_mps, locale, 3) : u"–"_s;
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
    return rows;
}

/** Sets one block after the other from the top of the page. */
class OperationLayout
{
public:
    explicit OperationLayout(const QSizeF& page) : m_set(page)
    {
        m_set.free.setBottom(m_set.free.bottom() - linePitch_px(kBriefFoot.size_px) - kGap_px);
    }

    BriefLayout laidOut(const OperationContent& content)
    {
        QRectF& free = m_set.free;
        const double foot_px = linePitch_px(kBriefFoot.size_px);
        setText(m_set.layout, QRectF(free.left(), free.bottom() + kGap_px, free.width(), foot_px),
                OperationPage::tr("Made by Bergwatch from the scenario. It says nothing about "
                                  "whether the operation may be flown."),
                kBriefFoot);
        for (const QString& text : wrapped(content.title, kBriefTitle, free.width(), kMostLines))
            m_set.line(text, kBriefTitle);
        m_set.line(content.about, kBriefHead);
        m_set.rule(true);
        m_set.setFacts(content.volume, 3);
        m_set.taken(kGap_px);
        for (const QString& formula : content.formulas)
            for (const QString& text : wrapped(formula, kWords, free.width(), kMostLines))
                m_set.line(text, kWords);
        m_set.taken(kGap_px);
        m_set.rule(false);
        m_set.setUavTable(content.uavs);
        m_set.taken(kGap_px);
        m_set.rule(false);
        for (const BriefFact& paper : content.papers)
            setPaper(paper);
        setChecklist(content.checklist);
        return std::move(m_set.layout);
    }

private:
    void blankLine(double left_px)
    {
        const double y = m_set.taken(kBlankLine_px).bottom();
        m_set.layout.rules.push_back({QLineF(left_px, y, m_set.free.right(), y), false});
    }

    void setPaper(const BriefFact& paper)
    {
        m_set.line(paper.caption, kBriefCaption);
        const QStringList words = wrapped(paper.value, kWords, m_set.free.width(), kMostLines);
        if (paper.value.isEmpty())
            for (int i = 0; i < kBlankLines; ++i)
                blankLine(m_set.free.left());
        else
            for (const QString& text : words)
                m_set.line(text, kWords);
        m_set.taken(kGap_px);
    }

    /** A box before each item; at the end lines for what is not foreseen. */
    void setChecklist(const QStringList& items)
    {
        m_set.line(OperationPage::tr("Checklist"), kHeading);
        qsizetype shown = 0;
        while (shown < items.size() && m_set.free.height() > 2 * kBlankLine_px)
            setItem(items[shown++]);
        if (shown < items.size()) {
            m_set.line(OperationPage::tr("and %1 more").arg(items.size() - shown), kWords);
            return;
        }
        constexpr qsizetype kMostBlank = 6;
        for (qsizetype i = 0;
             items.isEmpty() && i < kMostBlank && m_set.free.height() > kBlankLine_px; ++i)
            setItem({});
    }

    void setItem(const QString& item)
    {
        const QRectF strip = m_set.taken(kBlankLine_px);
        const QRectF box(strip.left(), strip.bottom() - kBox_px - 2, kBox_px, kBox_px);
        for (const QLineF& side :
             {QLineF(box.topLeft(), box.topRight()), QLineF(box.topRight(), box.bottomRight()),
              QLineF(box.bottomRight(), box.bottomLeft()), QLineF(box.bottomLeft(), box.topLeft())})
            m_set.layout.rules.push_back({side, true});
        const double left_px = box.right() + kGap_px;
        if (item.isEmpty())
            m_set.layout.rules.push_back(
                {QLineF(left_px, box.bottom(), strip.right(), box.bottom()), false});
        const double height_px = linePitch_px(kWords.size_px);
        QRectF line(left_px, box.center().y() - height_px / 2, strip.right() - left_px, height_px);
        const QStringList words = wrapped(item, kWords, line.width(), kMostLines);
        for (const QString& text : words) {
            setText(m_set.layout, line, text, kWords);
            line.translate(0, height_px);
        }
        m_set.taken(height_px * static_cast<double>(std::max<qsizetype>(words.size(), 1) - 1));
    }

    PageSetting m_set;
};

} // namespace

namespace {

QStringList linesOf(const std::string& utf8)
{
    QStringList lines;
    for (const QString& line : QString::fromStdString(utf8).split(u'\n', Qt::SkipEmptyParts))
        lines << printable(line.toStdString());
    return lines;
}

/** In one paragraph, what is one line each still told apart. */
QString runOn(const std::string& utf8)
{
    return linesOf(utf8).join(u" \u00b7 "_s);
}

} // namespace

OperationContent operationContent(const ExportContent& content, const QLocale& locale)
{
    const Operation& operation = *content.scenario->operation;
    return {.title = OperationPage::tr("Operation volume: proposal, to be checked with your "
                                       "authority"),
            .about = pageTitle(content),
            .volume = volumeFacts(*content.operation, locale),
            .formulas = formulasOf(*content.scenario, *content.operation, locale),
            .uavs = uavRows(content, locale),
            .papers = {{OperationPage::tr("Crew"), runOn(operation.crew)},
                       {OperationPage::tr("Call sign"), printable(operation.callSign)},
                       {OperationPage::tr("Contacts"), runOn(operation.contacts)},
                       {OperationPage::tr("Command link"), runOn(operation.link)},
                       {OperationPage::tr("Date and signatures"), {}}},
            .checklist = linesOf(operation.checklist)};
}

BriefLayout layOutOperation(const OperationContent& content, const QSizeF& page)
{
    return OperationLayout(page).laidOut(content);
}

} // namespace berg
