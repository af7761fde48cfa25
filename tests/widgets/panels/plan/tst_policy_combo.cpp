#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"
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

/** Flights of which 90 % lie within 855 m² s of the mean. */
PolicyForecast known(double mean_m2s)
{
    PolicyForecast forecast{.state = ForecastState::Known, .share = 1};
    for (int flight = 0; flight < kDrawnFlights; ++flight)
        forecast.drawn_m2s.push_back(mean_m2s + 100 * (flight - (kDrawnFlights - 1) / 2.0));
    return forecast;
}

/** Returns equal forecasts except for two policies. */
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
    [[nodiscard]] bool isRecommended(PolicyKind policy) const
    {
        return offer(policy, PolicyDelegate::RecommendedRole).toString() == u"Recommended"_s;
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
        QCOMPARE(f.remark(PolicyKind::Visitation), u"70\u202f380 to 72\u202f090 · chosen"_s);
        QCOMPARE(f.figure(PolicyKind::Coverage), u"ζ 61\u202f230 m² s"_s);
        QVERIFY(f.remark(PolicyKind::Coverage).endsWith(u" · −14.0 %"_s));
        QVERIFY(f.remark(PolicyKind::Nearest).endsWith(u" · +26.3 %"_s));
        QVERIFY(f.offer(PolicyKind::Coverage, Qt::AccessibleTextRole)
                    .toString()
                    .contains(u"61\u202f230"_s));
        QVERIFY(f.offer(PolicyKind::Tour, Qt::ToolTipRole).toString().contains(u"20 times"_s));
    }

    void theOneThatIsSurelyLowestIsRecommended()
    {
        PolicyComboFixture f;
        f.panel.showForecasts(forecasts());
        for (const PolicyKind policy : kPolicies)
            QCOMPARE(f.isRecommended(policy), policy == PolicyKind::Coverage);
        QCOMPARE(f.line.text(), u"Predicted ζ 71\u202f230 m² s (70\u202f380 to 72\u202f090); "
                                u"recommended: Best predicted coverage"_s);
    }

    /** The lowest mean is not enough: in some worlds it is higher by more. */
    void withoutAClearWinnerNoneIsRecommended()
    {
        PolicyComboFixture f;
        PolicyForecastList list = forecasts();
        std::vector<double>& coverage_m2s = list[PolicyKind::Coverage].drawn_m2s;
        for (std::size_t flight = 0; flight < coverage_m2s.size(); ++flight)
            coverage_m2s[flight] = flight % 3 == 0 ? 95000 : 55000; // a mean of 69 000
        f.panel.showForecasts(list);
        for (const PolicyKind policy : kPolicies)
            QVERIFY(!f.isRecommended(policy));
        QVERIFY(f.remark(PolicyKind::Coverage).endsWith(u"−3.1 %"_s));
        QVERIFY(f.line.text().endsWith(u"; no policy is a clear winner"_s));
    }

    /** Most uncertain first and tau = 0 often have equal flights. */
    void ofPoliciesThatFlyTheSameTheChosenOneIsRecommended()
    {
        PolicyComboFixture f;
        PolicyForecastList list = forecasts();
        list[PolicyKind::Uncertainty] = list[PolicyKind::Visitation] = known(50000);
        f.panel.showForecasts(list);
        QVERIFY(f.isRecommended(PolicyKind::Visitation));
        QVERIFY(!f.isRecommended(PolicyKind::Uncertainty));
        QVERIFY(f.line.text().endsWith(u"; recommended"_s));
    }

    void noneIsRecommendedWhenOneIsTooSlow()
    {
        PolicyComboFixture f;
        PolicyForecastList list = forecasts();
        list[PolicyKind::Latency] = {.state = ForecastState::TooLong};
        f.panel.showForecasts(list);
        QCOMPARE(f.remark(PolicyKind::Latency), u"takes too long"_s);
        for (const PolicyKind policy : kPolicies)
            QVERIFY(!f.isRecommended(policy));
        QVERIFY(f.line.text().endsWith(u"; too slow to compare: Least waiting time"_s));
    }

    /** Without icebergs there is nothing to predict. */
    void nothingIsPredictedOfNothing()
    {
        PolicyComboFixture f;
        PolicyForecastList list;
        for (const PolicyKind policy : kPolicies)
            list[policy] = {.state = ForecastState::Known,
                            .share = 1,
                            .drawn_m2s = std::vector<double>(kDrawnFlights, 0)};
        f.panel.showForecasts(list);
        QCOMPARE(f.line.text(), u"No ζ to predict: there is no iceberg out of view."_s);
    }

    void setAgainstTheOneChosen()
    {
        PolicyComboFixture f;
        f.panel.showForecasts(forecasts());
        f.panel.showSettings({.policy = PolicyKind::Coverage});
        QVERIFY(f.remark(PolicyKind::Coverage).endsWith(u" · chosen"_s));
        QVERIFY(f.remark(PolicyKind::Visitation).endsWith(u" · +16.3 %"_s));
        QVERIFY(f.line.text().startsWith(u"Predicted ζ 61\u202f230 m² s ("_s));
        QVERIFY(f.line.text().endsWith(u"); recommended"_s));
        QSignalSpy edited(&f.panel, &TradeoffPanel::policyEdited);
        QTest::keyClick(&f.combo, Qt::Key_Up);
        QCOMPARE(edited.count(), 1);
        QCOMPARE(edited.front().front().value<PolicyKind>(), PolicyKind::Latency);
        QVERIFY(f.line.text().startsWith(u"Predicted ζ 90\u202f000 m² s ("_s));
    }

    /** The lowest policy is not stated before all are known. */
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
            QVERIFY(!f.isRecommended(policy));
        QCOMPARE(f.line.text(), u"Predicted ζ 71\u202f230 m² s (70\u202f380 to 72\u202f090)"_s);
        f.panel.showSettings({.policy = PolicyKind::Latency});
        QCOMPARE(f.line.text(), u"Predicting ζ…"_s);
        f.panel.showSettings({.policy = PolicyKind::Coverage});
        QCOMPARE(f.line.text(), u"Predicting ζ: 43 %"_s); // no figure that would still change
    }

    void limitsAndReasonsAreShown()
    {
        PolicyComboFixture f;
        PolicyForecastList list = forecasts();
        list[PolicyKind::Coverage] = {.state = ForecastState::TooLong};
        list[PolicyKind::Latency] = {.state = ForecastState::Impossible,
                                     .unsupportedReason = u"no such solver"_s};
        f.panel.showForecasts(list);
        QCOMPARE(f.remark(PolicyKind::Coverage), u"takes too long"_s);
        QVERIFY(f.offer(PolicyKind::Coverage, Qt::ToolTipRole).toString().contains(u"2 min"_s));
        QVERIFY(
            f.offer(PolicyKind::Latency, Qt::ToolTipRole).toString().contains(u"no such solver"_s));
        f.panel.showSettings({.policy = PolicyKind::Coverage});
        QVERIFY(f.line.text().contains(u"takes too long"_s));
        QVERIFY(!f.remark(PolicyKind::Visitation).contains(u'%')); // nothing to compare with
    }

    /** In flight the forecasts are marked as made before take-off. */
    void forecastsAreMarkedInFlight()
    {
        PolicyComboFixture f;
        f.panel.showForecasts(forecasts());
        QVERIFY(f.offer(PolicyKind::Tour, PolicyDelegate::PresentRole).toBool());
        f.panel.setInFlight(true);
        QVERIFY(!f.offer(PolicyKind::Tour, PolicyDelegate::PresentRole).toBool());
        QCOMPARE(f.line.text(), u"Predicted before take-off: ζ 71\u202f230 m² s "
                                u"(70\u202f380 to 72\u202f090)"_s);
        f.panel.setInFlight(false);
        QVERIFY(f.offer(PolicyKind::Tour, PolicyDelegate::PresentRole).toBool());
    }

    /** The list is wider than the dock, so that sentences are readable, but within the screen. */
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
