#include "widgets/print/operation_page.h"

#include "widgets/print/brief_surroundings.h"
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
constexpr double kBlankLine_px = 24; // height of a line for handwriting
constexpr int kBlankLines = 2;       // lines of an entry filled in by hand
constexpr int kMostLines = 4;        // lines of a text
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

/** Lays out the blocks of the page from top to bottom. */
class OperationLayout
{
public:
    explicit OperationLayout(const QSizeF& page) : m_composer(page)
    {
        m_composer.free.setBottom(m_composer.free.bottom() - linePitch_px(kBriefFoot.size_px) -
                                  kGap_px);
    }

    BriefLayout laidOut(const OperationContent& content)
    {
        QRectF& free = m_composer.free;
        const double foot_px = linePitch_px(kBriefFoot.size_px);
        setText(m_composer.layout,
                QRectF(free.left(), free.bottom() + kGap_px, free.width(), foot_px),
                OperationPage::tr("Made by Bergwatch from the scenario. It does not imply that "
                                  "the operation may be flown."),
                kBriefFoot);
        for (const QString& text : wrapped(content.title, kBriefTitle, free.width(), kMostLines))
            m_composer.line(text, kBriefTitle);
        m_composer.line(content.about, kBriefHead);
        m_composer.rule(true);
        m_composer.setFacts(content.volume, 3);
        m_composer.takeStrip(kGap_px);
        for (const QString& formula : content.formulas)
            for (const QString& text : wrapped(formula, kWords, free.width(), kMostLines))
                m_composer.line(text, kWords);
        m_composer.takeStrip(kGap_px);
        m_composer.rule(false);
        m_composer.setUavTable(content.uavs);
        m_composer.takeStrip(kGap_px);
        m_composer.rule(false);
        for (const BriefFact& paper : content.papers)
            setPaper(paper);
        setChecklist(content.checklist);
        return std::move(m_composer.layout);
    }

private:
    void blankLine(double left_px)
    {
        const double y = m_composer.takeStrip(kBlankLine_px).bottom();
        m_composer.layout.rules.push_back({QLineF(left_px, y, m_composer.free.right(), y), false});
    }

    void setPaper(const BriefFact& paper)
    {
        m_composer.line(paper.caption, kBriefCaption);
        const QStringList words = wrapped(paper.value, kWords, m_composer.free.width(), kMostLines);
        if (paper.value.isEmpty())
            for (int i = 0; i < kBlankLines; ++i)
                blankLine(m_composer.free.left());
        else
            for (const QString& text : words)
                m_composer.line(text, kWords);
        m_composer.takeStrip(kGap_px);
    }

    /** Sets a check box before each item, or blank lines if there are no items. */
    void setChecklist(const QStringList& items)
    {
        m_composer.line(OperationPage::tr("Checklist"), kHeading);
        qsizetype shown = 0;
        while (shown < items.size() && m_composer.free.height() > 2 * kBlankLine_px)
            setItem(items[shown++]);
        if (shown < items.size()) {
            m_composer.line(OperationPage::tr("and %1 more").arg(items.size() - shown), kWords);
            return;
        }
        constexpr qsizetype kMostBlank = 6;
        for (qsizetype i = 0;
             items.isEmpty() && i < kMostBlank && m_composer.free.height() > kBlankLine_px; ++i)
            setItem({});
    }

    void setItem(const QString& item)
    {
        const QRectF strip = m_composer.takeStrip(kBlankLine_px);
        const QRectF box(strip.left(), strip.bottom() - kBox_px - 2, kBox_px, kBox_px);
        for (const QLineF& side :
             {QLineF(box.topLeft(), box.topRight()), QLineF(box.topRight(), box.bottomRight()),
              QLineF(box.bottomRight(), box.bottomLeft()), QLineF(box.bottomLeft(), box.topLeft())})
            m_composer.layout.rules.push_back({side, true});
        const double left_px = box.right() + kGap_px;
        if (item.isEmpty())
            m_composer.layout.rules.push_back(
                {QLineF(left_px, box.bottom(), strip.right(), box.bottom()), false});
        const double height_px = linePitch_px(kWords.size_px);
        QRectF line(left_px, box.center().y() - height_px / 2, strip.right() - left_px, height_px);
        const QStringList words = wrapped(item, kWords, line.width(), kMostLines);
        for (const QString& text : words) {
            setText(m_composer.layout, line, text, kWords);
            line.translate(0, height_px);
        }
        m_composer.takeStrip(height_px *
                             static_cast<double>(std::max<qsizetype>(words.size(), 1) - 1));
    }

    PageComposer m_composer;
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

/** Joins lines to one paragraph, separated by dots. */
QString oneParagraph(const std::string& utf8)
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
            .papers = {{OperationPage::tr("Crew"), oneParagraph(operation.crew)},
                       {OperationPage::tr("Call sign"), printable(operation.callSign)},
                       {OperationPage::tr("Contacts"), oneParagraph(operation.contacts)},
                       {OperationPage::tr("Command link"), oneParagraph(operation.link)},
                       {OperationPage::tr("Date and signatures"), {}}},
            .checklist = linesOf(operation.checklist)};
}

BriefLayout layOutOperation(const OperationContent& content, const QSizeF& page)
{
    return OperationLayout(page).laidOut(content);
}

} // namespace berg
