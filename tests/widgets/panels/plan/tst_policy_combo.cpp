#include "tests/support/panel_test.h"
#include "widgets/panels/plan/policy_combo.h"
#include "widgets/panels/plan/tradeoff_panel.h"
#include "widgets/words/policy_words.h"

#include <QAbstractItemView>
#include <QLabel>
#include <QScreen>
#include <QSignalSpy>
#include <QStyleOptionComboBox>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

constexpr std::array kPolicies{PolicyKind::Visitation, PolicyKind::Path,    PolicyKind::Tour,
                               PolicyKind::Nearest,    PolicyKind::Latency, PolicyKind::Coverage,
                               PolicyKind::Uncertainty};

PolicyForecast known(double zeta_m2s)
{
    return {.state = ForecastState::Known, .share = 1, .metrics = {.zeta_m2s = zeta_m2s}};
}

/** All the same but two. */
PolicyForecastList forecasts()
{
    PolicyForecastList list;
    for (const PolicyKind policy : kPolicies)
        list[policy] = known(90000);
    list[PolicyKind::Visitation] = known(71234);
    list[PolicyKind::Coverage] = known(61234);
    return list;
}

struct PolicyComboFixture
{
    TradeoffPanel panel;
    PolicyCombo& combo = *panel.findChild<PolicyCombo*>(u"policyCombo"_s);
    QLabel& line = test::child<QLabel>(panel, u"policyForecast"_s);

    PolicyComboFixture()
    {
        panel.setLocale(QLocale::c());
        panel.resize(test::kDock_px, 360);
        panel.show();
    }
    [[nodiscard]] QVariant offer(PolicyKind policy, int role) const
    {
        return combo.itemData(combo.findData(static_cast<int>(policy)), role);
    }
    [[nodiscard]] QString figure(PolicyKind policy) const
    {
        return offer(policy, PolicyDelegate::FigureRole).toString();
    }
    [[nodiscard]] QString remark(PolicyKind policy) const
    {
        return offer(policy, PolicyDelegate::RemarkRole).toString();
    }
    [[nodiscard]] bool isLowest(PolicyKind policy) const
    {
        return !offer(policy, PolicyDelegate::LowestRole).toString().isEmpty();
    }
};

} // namespace

/** The predicted zeta of each policy, where policies are chosen. */
class TestPolicyCombo : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void offersSayWhatTheyComeTo()
    {
        PolicyComboFixture f;
        f.panel.showForecasts(forecasts());
        QCOMPARE(f.figure(PolicyKind::Visitation), u"ζ 71\u202f230 m² s"_s);
        QCOMPARE(f.remark(PolicyKind::Visitation), u"chosen"_s);
        QCOMPARE(f.figure(PolicyKind::Coverage), u"ζ 61\u202f230 m² s"_s);
        QCOMPARE(f.remark(PolicyKind::Coverage), u"−14.0 %"_s);
        QCOMPARE(f.remark(PolicyKind::Nearest), u"+26.3 %"_s);
        for (const PolicyKind policy : kPolicies)
            QCOMPARE(f.isLowest(policy), policy == PolicyKind::Coverage);
        QCOMPARE(f.line.text(), u"Predicted ζ 71\u202f230 m² s, lowest −14.0 %"_s);
        QVERIFY(f.offer(PolicyKind::Coverage, Qt::AccessibleTextRole)
                    .toString()
                    .contains(u"61\u202f230"_s));
        QVERIFY(f.offer(PolicyKind::Tour, Qt::ToolTipRole).toString().contains(u"noise"_s));
    }

    /** Once all were flown in drawn worlds: what is lower without noise need not be lower then. */
    void meanAndRangeOfDrawnWorlds()
    {
        PolicyComboFixture f;
        PolicyForecastList list = forecasts();
        for (auto& [policy, forecast] : list)
            for (int flight = 0; flight < 20; ++flight) // means of 49 500 and 80 000
                forecast.drawn_m2s.push_back(policy == PolicyKind::Latency ? 40000 + 1000 * flight
                                                                           : 70500 + 1000 * flight);
        PolicyForecastList partial = list;
        partial[PolicyKind::Coverage].drawn_m2s.pop_back();
        f.panel.showForecasts(partial);
        QCOMPARE(f.figure(PolicyKind::Visitation), u"ζ 71\u202f230 m² s"_s);
        QCOMPARE(f.offer(PolicyKind::Coverage, PolicyDelegate::LowestRole).toString(), u"Lowest"_s);

        f.panel.showForecasts(list);
        QCOMPARE(f.figure(PolicyKind::Visitation), u"ζ 80\u202f000 m² s"_s);
        QCOMPARE(f.remark(PolicyKind::Visitation), u"71\u202f450 to 88\u202f550 · chosen"_s);
        QCOMPARE(f.offer(PolicyKind::Latency, PolicyDelegate::LowestRole).toString(),
                 u"Recommended"_s);
        QVERIFY(f.remark(PolicyKind::Latency).endsWith(u"−38.1 %"_s));
        QVERIFY(!f.isLowest(PolicyKind::Coverage));
        QCOMPARE(f.line.text(), u"Mean ζ 80\u202f000 m² s (71\u202f450 to 88\u202f550), "
                                u"lowest −38.1 %"_s);
        f.panel.setInFlight(true);
        for (const PolicyForecastList& flown : {list, partial}) { // as the card at the end has it
            f.panel.showForecasts(flown);
            QCOMPARE(f.line.text(), u"Predicted before take-off: ζ 80\u202f000 m² s "
                                    u"(71\u202f450 to 88\u202f550)"_s);
        }
    }

    /** Ranges are shown of those that were flown; with one left out none is recommended. */
    void rangesWhenOnePolicyIsTooSlow()
    {
        PolicyComboFixture f;
        PolicyForecastList list = forecasts();
        for (auto& [policy, forecast] : list) {
            forecast.drawn_m2s.assign(20, 80000);
            forecast.drawsNoMore = true;
        }
        list[PolicyKind::Coverage].drawn_m2s.resize(3);
        f.panel.showForecasts(list);
        QCOMPARE(f.remark(PolicyKind::Visitation), u"80\u202f000 to 80\u202f000 · chosen"_s);
        QVERIFY(f.remark(PolicyKind::Coverage).startsWith(u"too slow for 20 flights"_s));
        QCOMPARE(f.figure(PolicyKind::Coverage), u"ζ 61\u202f230 m² s"_s);
        for (const PolicyKind policy : kPolicies)
            QVERIFY(!f.isLowest(policy));
        QCOMPARE(f.line.text(), u"Mean ζ 80\u202f000 m² s (80\u202f000 to 80\u202f000); "
                                u"too slow to compare: Best predicted coverage"_s);
    }

    /** One that was not predicted has no part in it. */
    void drawnWorldsOfThoseThatAreKnown()
    {
        PolicyComboFixture f;
        PolicyForecastList list = forecasts();
        for (auto& [policy, forecast] : list)
            forecast.drawn_m2s.assign(20, 80000);
        list[PolicyKind::Coverage] = {.state = ForecastState::TooLong};
        f.panel.showForecasts(list);
        QCOMPARE(f.figure(PolicyKind::Visitation), u"ζ 80\u202f000 m² s"_s);
        QCOMPARE(f.remark(PolicyKind::Coverage), u"takes too long"_s);
    }

    void setAgainstTheOneChosen()
    {
        PolicyComboFixture f;
        f.panel.showForecasts(forecasts());
        f.panel.showSettings({.policy = PolicyKind::Coverage});
        QCOMPARE(f.remark(PolicyKind::Coverage), u"chosen"_s);
        QCOMPARE(f.remark(PolicyKind::Visitation), u"+16.3 %"_s);
        QCOMPARE(f.line.text(), u"Predicted ζ 61\u202f230 m² s, the lowest"_s);
        QSignalSpy edited(&f.panel, &TradeoffPanel::policyEdited);
        QTest::keyClick(&f.combo, Qt::Key_Up);
        QCOMPARE(edited.count(), 1);
        QCOMPARE(edited.front().front().value<PolicyKind>(), PolicyKind::Latency);
        QCOMPARE(f.line.text(), u"Predicted ζ 90\u202f000 m² s, lowest −32.0 %"_s);
    }

    /** Which is lowest is not told before all are known. */
    void whileForecastsAreMade()
    {
        PolicyComboFixture f;
        QVERIFY(f.line.text().isEmpty());
        PolicyForecastList list = forecasts();
        list[PolicyKind::Coverage] = {.state = ForecastState::Computing, .share = 0.434};
        list[PolicyKind::Latency] = {};
        f.panel.showForecasts(list);
        QCOMPARE(f.figure(PolicyKind::Coverage), u"43 %…"_s);
        QCOMPARE(f.figure(PolicyKind::Latency), u"…"_s);
        QVERIFY(f.remark(PolicyKind::Latency).isEmpty());
        for (const PolicyKind policy : kPolicies)
            QVERIFY(!f.isLowest(policy));
        QCOMPARE(f.line.text(), u"Predicted ζ 71\u202f230 m² s"_s);
        f.panel.showSettings({.policy = PolicyKind::Latency});
        QCOMPARE(f.line.text(), u"Predicting ζ…"_s);
    }

    void limitsAndReasonsAreTold()
    {
        PolicyComboFixture f;
        PolicyForecastList list = forecasts();
        list[PolicyKind::Coverage] = {.state = ForecastState::TooLong};
        list[PolicyKind::Latency] = {.state = ForecastState::Impossible,
                                     .whyNot = u"no such solver"_s};
        f.panel.showForecasts(list);
        QCOMPARE(f.remark(PolicyKind::Coverage), u"takes too long"_s);
        QVERIFY(f.offer(PolicyKind::Coverage, Qt::ToolTipRole).toString().contains(u"1 min"_s));
        QVERIFY(
            f.offer(PolicyKind::Latency, Qt::ToolTipRole).toString().contains(u"no such solver"_s));
        QVERIFY(f.isLowest(PolicyKind::Visitation)); // of those that are known
        f.panel.showSettings({.policy = PolicyKind::Coverage});
        QVERIFY(f.line.text().contains(u"takes too long"_s));
        QVERIFY(f.remark(PolicyKind::Visitation).isEmpty()); // nothing to be set against
    }

    /** In flight they are those of before take-off, and look it. */
    void inFlight()
    {
        PolicyComboFixture f;
        f.panel.showForecasts(forecasts());
        QVERIFY(f.offer(PolicyKind::Tour, PolicyDelegate::PresentRole).toBool());
        f.panel.setInFlight(true);
        QVERIFY(!f.offer(PolicyKind::Tour, PolicyDelegate::PresentRole).toBool());
        QCOMPARE(f.line.text(), u"Predicted before take-off: ζ 71\u202f230 m² s"_s);
        f.panel.setInFlight(false);
        QVERIFY(f.offer(PolicyKind::Tour, PolicyDelegate::PresentRole).toBool());
    }

    /** The list is wider than the dock, so that sentences are read, and on the screen. */
    void listHasRoomForItsTexts()
    {
        PolicyComboFixture f;
        f.panel.showForecasts(forecasts());
        f.panel.move(f.panel.screen()->availableGeometry().right() - test::kDock_px, 10);
        f.combo.showPopup();
        const QWidget& popup = *f.combo.view()->window();
        QTRY_VERIFY(popup.isVisible());
        const QFontMetrics small(Theme::light().small());
        for (const PolicyKind policy : kPolicies)
            QVERIFY(
                f.combo.view()->width() >
                small.horizontalAdvance(f.offer(policy, PolicyDelegate::SentenceRole).toString()) +
                    small.horizontalAdvance(f.remark(policy)));
        QVERIFY(f.panel.screen()->geometry().contains(popup.geometry()));
        f.combo.hidePopup();
    }

    void longNamesAreElided()
    {
        struct Combo : PolicyCombo
        {
            [[nodiscard]] QString drawnText(int width_px)
            {
                resize(width_px, 24);
                QStyleOptionComboBox option;
                initStyleOption(&option);
                return option.currentText;
            }
        };
        Combo combo;
        combo.showPolicy(PolicyKind::Visitation);
        QCOMPARE(combo.drawnText(900), policyName(PolicyKind::Visitation));
        QVERIFY(combo.drawnText(80).endsWith(u'…'));
        QCOMPARE(combo.currentText(), policyName(PolicyKind::Visitation)); // as it is spoken
    }

    void longTextsFitTheDock()
    {
        const test::LongerTexts longer;
        PolicyComboFixture f;
        f.panel.showForecasts(forecasts());
        QVERIFY(f.panel.minimumSizeHint().width() <= test::kDock_px);
    }
};

QTEST_MAIN(TestPolicyCombo)
#include "tst_policy_combo.moc"
