#include "core/plan/policy/policy.h"
#include "tests/support/approx.h"
#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/plan/tradeoff_panel.h"

#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QSlider>
#include <QStandardItemModel>
#include <QToolButton>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/** The panel on screen, its inputs and a spy on each intent. */
struct TradeoffFixture
{
    TradeoffPanel panel;
    QSlider& slider = test::child<QSlider>(panel, u"tauSlider"_s);
    NumberField& field = test::child<NumberField>(panel, u"tauField"_s);
    QComboBox& policy = test::child<QComboBox>(panel, u"policyCombo"_s);
    QComboBox& solver = test::child<QComboBox>(panel, u"solverCombo"_s);
    QComboBox& route = test::child<QComboBox>(panel, u"routeCombo"_s);
    QSignalSpy tauEdited{&panel, &TradeoffPanel::tauEdited};
    QSignalSpy tauFinished{&panel, &TradeoffPanel::tauEditFinished};
    QSignalSpy policyEdited{&panel, &TradeoffPanel::policyEdited};
    QSignalSpy backendEdited{&panel, &TradeoffPanel::backendEdited};
    QSignalSpy routeEdited{&panel, &TradeoffPanel::routeEdited};

    TradeoffFixture()
    {
        panel.resize(test::kDock_px, 360);
        panel.show();
    }
    [[nodiscard]] qsizetype intents() const
    {
        return tauEdited.count() + tauFinished.count() + policyEdited.count() +
               backendEdited.count() + routeEdited.count();
    }
    [[nodiscard]] QString text(const QString& name) const
    {
        return test::child<QLabel>(panel, name).text();
    }
};

/** Returns a plan that is proven optimal, changed by `change`. */
PlanPointer planWith(const std::function<void(Plan&)>& change)
{
    Plan plan{.uavs = {{.order = {1, 0}}},
              .outcome = {.status = SolveStatus::Optimal,
                          .objective = -130,
                          .bound = -130.0,
                          .elapsed_s = 0.004,
                          .source = AnswerSource::Exact},
              .problem = {.distance_m = {}, .sigma_m2 = {}, .mu = 0.02},
              .gap = 0.0,
              .distance_m = 14200};
    change(plan);
    return std::make_shared<const Plan>(std::move(plan));
}

PlanPointer provenPlan()
{
    return planWith([](Plan&) {});
}

/** Returns an unproven plan with this gap. */
PlanPointer goodPlan(std::optional<double> gap)
{
    return planWith([gap](Plan& plan) {
        plan.outcome.status = SolveStatus::Feasible;
        plan.outcome.source = AnswerSource::Heuristic;
        plan.outcome.elapsed_s = 0.012;
        plan.gap = gap;
    });
}

/** Returns a proven plan for several UAVs. */
PlanPointer fleetPlan(const OrdersByUav& orders)
{
    return planWith([&orders](Plan& plan) {
        plan.uavs.clear();
        for (const IcebergList& order : orders)
            plan.uavs.push_back({.uav = static_cast<int>(plan.uavs.size()), .order = order});
    });
}

} // namespace

class TestTradeoffPanel : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void showingSettingsEmitsNothing()
    {
        TradeoffFixture f;
        f.panel.showSettings({.policy = PolicyKind::Tour,
                              .tau = 2.345,
                              .route = Route::Closed,
                              .backend = Backend::Heuristic});
        QCOMPARE(f.slider.value(), 235); // 2.345 is nearer to it than to 234 in binary
        QCOMPARE(f.field.value(), 2.345);
        QCOMPARE(f.policy.currentData().toInt(), static_cast<int>(PolicyKind::Tour));
        QCOMPARE(f.solver.currentData().toInt(), static_cast<int>(Backend::Heuristic));
        QCOMPARE(f.route.currentData().toInt(), static_cast<int>(Route::Closed));
        f.panel.showSettings({.tau = 1.0 / 3});
        QCOMPARE(f.field.value(), 0.333);
        QCOMPARE(f.intents(), 0);
    }

    void sliderEmitsTheDecimalNumberOnce()
    {
        TradeoffFixture f;
        f.slider.setSliderDown(true);
        f.slider.setValue(130);
        QCOMPARE(f.tauEdited.count(), 1);
        QCOMPARE(f.tauEdited.front().front().toDouble(), 1.3); // exactly the typed number
        f.panel.showSettings({.tau = 1.3});                    // the response of the document
        QCOMPARE(f.field.value(), 1.3);
        f.slider.setSliderDown(false);
        QCOMPARE(f.tauEdited.count(), 1);
        QCOMPARE(f.tauFinished.count(), 1);
    }

    void dragIsNotPulledBackByAnOlderPicture()
    {
        TradeoffFixture f;
        f.slider.setSliderDown(true);
        f.slider.setValue(200);
        f.panel.showSettings({.tau = 1.0});
        QCOMPARE(f.slider.value(), 200);
        f.slider.setSliderDown(false);
        f.panel.showSettings({.tau = 1.0});
        QCOMPARE(f.slider.value(), 100);
        QCOMPARE(f.tauEdited.count(), 1);
    }

    void pressOnTheGrooveJumpsThere()
    {
        TradeoffFixture f;
        const QPoint at(f.slider.width() * 8 / 10, f.slider.height() / 2);
        QTest::mousePress(&f.slider, Qt::LeftButton, {}, at);
        // The handle is some 15 px wide on some 280 px: tau 4 within what it covers.
        COMPARE_NEAR(f.tauEdited.back().front().toDouble(), 4.0, 0.3);
        QCOMPARE(f.tauFinished.count(), 0);
        QTest::mouseRelease(&f.slider, Qt::LeftButton, {}, at);
        QCOMPARE(f.tauFinished.count(), 1);
    }

    void keysMoveTheSlider_data()
    {
        QTest::addColumn<int>("key");
        QTest::addColumn<double>("tau");
        QTest::newRow("right") << int{Qt::Key_Right} << 1.01;
        QTest::newRow("left") << int{Qt::Key_Left} << 0.99;
        QTest::newRow("page up") << int{Qt::Key_PageUp} << 1.25;
        QTest::newRow("home") << int{Qt::Key_Home} << 0.0;
        QTest::newRow("end") << int{Qt::Key_End} << 5.0;
    }

    void keysMoveTheSlider()
    {
        QFETCH(int, key);
        QFETCH(double, tau);
        TradeoffFixture f;
        QTest::keyClick(&f.slider, static_cast<Qt::Key>(key));
        QCOMPARE(f.tauEdited.count(), 1);
        QCOMPARE(f.tauEdited.front().front().toDouble(), tau);
        QTRY_COMPARE(f.tauFinished.count(), 1); // keys have no release of their own
    }

    void typedValueBeyondTheSliderPinsIt()
    {
        TradeoffFixture f;
        test::enter(f.field, u"12.5"_s);
        QCOMPARE(f.tauEdited.count(), 1);
        QCOMPARE(f.tauEdited.front().front().toDouble(), 12.5);
        QCOMPARE(f.tauFinished.count(), 1);
        QCOMPARE(f.slider.value(), f.slider.maximum());
        f.panel.showSettings({.tau = 12.5});
        QCOMPARE(f.tauEdited.count(), 1);
        QCOMPARE(f.field.value(), 12.5);
    }

    void equalSettingsLeaveTypingAlone()
    {
        TradeoffFixture f;
        f.field.setFocus();
        QTest::keyClick(&f.field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(&f.field, u"3."_s);
        f.panel.showSettings({});
        QCOMPARE(f.field.text(), u"3."_s);
        QCOMPARE(f.tauEdited.count(), 0);
    }

    void choicesAreEmittedOnce()
    {
        TradeoffFixture f;
        QTest::keyClick(&f.policy, Qt::Key_Down);
        QCOMPARE(f.policyEdited.count(), 1);
        QCOMPARE(f.policyEdited.front().front().value<PolicyKind>(), PolicyKind::Latency);
        f.panel.showSettings({.policy = PolicyKind::Latency});
        f.panel.showSettings({});
        QTest::keyClick(&f.solver, Qt::Key_Down);
        QCOMPARE(f.backendEdited.count(), 1);
        QCOMPARE(f.backendEdited.front().front().value<Backend>(), Backend::Exact);
        QTest::keyClick(&f.route, Qt::Key_Down);
        QCOMPARE(f.routeEdited.count(), 1);
        QCOMPARE(f.routeEdited.front().front().value<Route>(), Route::Closed);
        QCOMPARE(f.intents(), 3);
    }

    void everyPolicyIsOfferedAndExplained()
    {
        TradeoffFixture f;
        QCOMPARE(f.policy.count(), static_cast<int>(std::size(kPolicyNames)));
        QSet<QString> sentences;
        for (int row = 0; row < f.policy.count(); ++row)
            sentences << f.policy.itemData(row, Qt::ToolTipRole).toString();
        QCOMPARE(sentences.size(), f.policy.count());
        QVERIFY(!sentences.contains(QString()));
        f.panel.showSettings({.policy = PolicyKind::Coverage});
        QCOMPARE(f.policy.currentData().value<PolicyKind>(), PolicyKind::Coverage);
        QVERIFY(sentences.contains(f.policy.toolTip()));
        QVERIFY(!f.solver.isEnabled());
        f.panel.showSettings({.policy = PolicyKind::Latency});
        QVERIFY(f.solver.isEnabled());
        QCOMPARE(f.intents(), 0);
    }

    void solversThatThisBuildLacksCannotBeChosen()
    {
        const TradeoffFixture f;
        const auto* model = qobject_cast<QStandardItemModel*>(f.solver.model());
        for (int row = 0; row < f.solver.count(); ++row) {
            bool there = true;
            try {
                there = makeSolver(static_cast<Backend>(f.solver.itemData(row).toInt())) != nullptr;
            } catch (const Error&) {
                there = false;
            }
            QCOMPARE(model->item(row)->isEnabled(), there);
            QCOMPARE(f.solver.itemData(row, Qt::ToolTipRole).toString().isEmpty(), there);
        }
    }

    void flightLocksSolverAndRoute()
    {
        TradeoffFixture f;
        const QString before = f.solver.toolTip();
        f.panel.setInFlight(true);
        QVERIFY(f.slider.isEnabled() && f.field.isEnabled() && f.policy.isEnabled());
        QVERIFY(!f.solver.isEnabled() && !f.route.isEnabled());
        QVERIFY(f.solver.toolTip().contains(u"locked in flight"_s));
        QVERIFY(f.route.toolTip().contains(u"locked in flight"_s));
        f.panel.setInFlight(false);
        QVERIFY(f.solver.isEnabled() && f.route.isEnabled());
        QCOMPARE(f.solver.toolTip(), before);
    }

    void inputsThePolicyDoesNotUseAreOff_data()
    {
        QTest::addColumn<PolicyKind>("policy");
        QTest::addColumn<bool>("tau");
        QTest::addColumn<bool>("solver");
        QTest::newRow("visitation") << PolicyKind::Visitation << true << true;
        QTest::newRow("tour") << PolicyKind::Tour << false << true;
        QTest::newRow("nearest") << PolicyKind::Nearest << false << false;
    }

    void inputsThePolicyDoesNotUseAreOff()
    {
        QFETCH(PolicyKind, policy);
        QFETCH(bool, tau);
        QFETCH(bool, solver);
        TradeoffFixture f;
        f.panel.showSettings({.policy = policy});
        QCOMPARE(f.slider.isEnabled(), tau);
        QCOMPARE(f.field.isEnabled(), tau);
        QCOMPARE(f.solver.isEnabled(), solver);
        QVERIFY(f.policy.isEnabled());
    }

    void stateIsInWords_data()
    {
        QTest::addColumn<PlanReadout>("readout");
        QTest::addColumn<PlanVerdict>("verdict");
        QTest::addColumn<QString>("text");
        const auto row = [](const char* name, PlanReadout readout, PlanVerdict verdict,
                            const QString& text) {
            QTest::newRow(name) << std::move(readout) << verdict << text;
        };
        row("nothing", {}, PlanVerdict::None, u"No plan yet"_s);
        row("first plan", {.solving = true}, PlanVerdict::None, u"Planning…"_s);
        row("proven", {.plan = provenPlan()}, PlanVerdict::Proven,
            u"Proven optimal, under 0.1 s (exact)"_s);
        row("gap", {.plan = goodPlan(0.008)}, PlanVerdict::Estimate,
            u"Within 0.8 % of optimal, under 0.1 s"_s);
        row("gap is rounded up", {.plan = goodPlan(0.0121)}, PlanVerdict::Estimate,
            u"Within 1.3 % of optimal, under 0.1 s"_s);
        row("tiny gap is not called none", {.plan = goodPlan(1e-7)}, PlanVerdict::Estimate,
            u"Within 0.1 % of optimal, under 0.1 s"_s);
        row("no bound", {.plan = goodPlan(std::nullopt)}, PlanVerdict::Estimate,
            u"Best order found, under 0.1 s"_s);
        row("while solving", {.plan = goodPlan(std::nullopt), .solving = true},
            PlanVerdict::Estimate, u"Best order so far"_s);
        row("limit", {.plan = planWith([](Plan& plan) {
                          plan.outcome.status = SolveStatus::None;
                          plan.outcome.reason = StopReason::TimeLimit;
                          plan.uavs[0].reason = PlanReason::TargetReached;
                          plan.fellBack = true;
                      })},
            PlanVerdict::Warning, u"Solver limit reached; previous plan kept"_s);
        row("limit at the start", {.plan = planWith([](Plan& plan) {
                                       plan.outcome.status = SolveStatus::None;
                                       plan.uavs[0].reason = PlanReason::Start;
                                       plan.fellBack = true;
                                   })},
            PlanVerdict::Warning, u"Solver limit reached; flying to the nearest iceberg"_s);
        row("too large", {.plan = planWith([](Plan& plan) {
                              plan.outcome.status = SolveStatus::None;
                              plan.outcome.reason = StopReason::Unable;
                              plan.fellBack = true;
                          })},
            PlanVerdict::Warning,
            u"This solver cannot plan so many icebergs: choose Automatic (auto)"_s);
        row("fault", {.plan = provenPlan(), .fault = u"Too windy."_s}, PlanVerdict::Fault,
            u"Too windy."_s);
        row("all in view", {.plan = planWith([](Plan& plan) { plan.uavs[0].order.clear(); })},
            PlanVerdict::None, u"Nothing to visit now"_s);
        row("fleet", {.plan = fleetPlan({{1, 0}, {7, 8}, {}})}, PlanVerdict::Proven,
            u"Proven optimal, under 0.1 s (exact) · 3 UAVs, 4 icebergs"_s);
        row("first of a fleet has nothing", {.plan = fleetPlan({{}, {3, 1}})}, PlanVerdict::Proven,
            u"Proven optimal, under 0.1 s (exact) · 2 UAVs, 2 icebergs"_s);
        row("fleet with nothing", {.plan = fleetPlan({{}, {}})}, PlanVerdict::None,
            u"Nothing to visit now"_s);
        row("greedy",
            {.plan = planWith([](Plan& plan) { plan.outcome.source = AnswerSource::OneByOne; })},
            PlanVerdict::None, u"Chosen one iceberg at a time"_s);
    }

    void stateIsInWords()
    {
        QFETCH(PlanReadout, readout);
        QFETCH(PlanVerdict, verdict);
        QFETCH(QString, text);
        const PlanState state = planState(readout, QLocale::c());
        QCOMPARE(state.text, text);
        QCOMPARE(state.verdict, verdict);
    }

    void solverDetailsAreInTheToolTip()
    {
        TradeoffFixture f;
        f.panel.showPlan({.plan = provenPlan()});
        QCOMPARE(f.text(u"planState"_s), u"Proven optimal, under 0.1 s (exact)"_s);
        const QString details = test::child<QLabel>(f.panel, u"planState"_s).toolTip();
        for (const QString& part : {u"exact"_s, u"optimal"_s, u"-130"_s})
            QVERIFY2(details.contains(part), qPrintable(details));
    }

    void figuresFollowTheObjective()
    {
        TradeoffFixture f;
        f.panel.setLocale(QLocale::c());
        f.panel.showPlan({.plan = provenPlan()});
        QCOMPARE(f.text(u"planDistance"_s), u"14.2 km"_s);
        QCOMPARE(f.text(u"planReward"_s), u"414 m²"_s); // 0.02 x 14200 + 130
        QCOMPARE(f.text(u"planObjective"_s), u"-130.0 m²"_s);
        QCOMPARE(f.text(u"planMu"_s), u"0.0200 m²/m"_s);
    }

    void whatTheSolverMinimisesIsFolded()
    {
        TradeoffFixture f;
        f.panel.show();
        auto& objective = test::child<QLabel>(f.panel, u"planObjective"_s);
        auto& details = test::child<QToolButton>(f.panel, u"planDetails"_s);
        QVERIFY(!objective.isVisible());
        QVERIFY(test::child<QLabel>(f.panel, u"planDistance"_s).isVisible());
        details.click();
        QVERIFY(objective.isVisible());
        details.click();
        QVERIFY(!objective.isVisible());
    }

    void figuresThatAPolicyDoesNotWeighAreLeftOut()
    {
        const PlanFigures path = planFigures({.plan = provenPlan()}, PolicyKind::Path);
        QVERIFY(path.distance_m && !path.reward_m2 && !path.objective_m2 && !path.mu_m);
        const PlanFigures none = planFigures({.plan = planWith([](Plan& plan) {
                                                  plan.outcome.status = SolveStatus::None;
                                                  plan.fellBack = true;
                                              })},
                                             PolicyKind::Visitation);
        QVERIFY(!none.distance_m && !none.reward_m2);
        const PlanFigures fleet =
            planFigures({.plan = fleetPlan({{1, 0}, {1}})}, PolicyKind::Visitation);
        const PlanFigures one = planFigures({.plan = provenPlan()}, PolicyKind::Visitation);
        QVERIFY(fleet.reward_m2 && fleet.reward_m2 == one.reward_m2);
        QVERIFY(fleet.mu_m && fleet.mu_m == one.mu_m);
        QVERIFY(fleet.objective_m2 == one.objective_m2);
    }

    /** The state can have the focus only while it has a link. */
    void stateIsATabStopWithItsLinkAlone()
    {
        TradeoffFixture f;
        const auto& state = test::child<QLabel>(f.panel, u"planState"_s);
        const auto isTabStop = [&] { return (state.focusPolicy() & Qt::TabFocus) != 0; };
        QVERIFY(!isTabStop());
        f.panel.showPlan({.plan = provenPlan()});
        QVERIFY(!isTabStop());
        f.panel.showPlan({.plan = {}, .fault = u"No icebergs."_s});
        QVERIFY(isTabStop());
        f.panel.showPlan({.plan = provenPlan()});
        QVERIFY(!isTabStop());
    }

    void longTextsFitTheDock()
    {
        const test::LongerTexts longer;
        TradeoffFixture f;
        f.panel.showPlan({.plan = goodPlan(0.008)});
        QVERIFY(f.panel.minimumSizeHint().width() <= test::kDock_px);
    }

    void everyInputIsNamed()
    {
        const TradeoffFixture f;
        for (const QWidget* input : std::initializer_list<const QWidget*>{
                 &f.slider, &f.field, &f.policy, &f.solver, &f.route}) {
            QVERIFY(!input->accessibleName().isEmpty());
            QVERIFY(!input->toolTip().isEmpty());
        }
    }
};

QTEST_MAIN(TestTradeoffPanel)
#include "tst_tradeoff_panel.moc"
