#include "core/base/random.h"
#include "core/checks/validate.h"
#include "core/presets/presets.h"
#include "tests/support/window/window_fixture.h"

#include <QComboBox>
#include <QTableView>
#include <QUndoStack>
#include <QWheelEvent>

#include <array>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

/** A user without a plan: draws what to do next and does it. */
class AnyUser
{
public:
    AnyUser(WindowFixture& window, std::uint64_t seed) : w(window), m_random(seed, 99) {}

    void act()
    {
        switch (m_random.below(10)) {
        case 0:
        case 1:
            w.click(place());
            break;
        case 2:
            QTest::mouseDClick(&w.map(), Qt::LeftButton, {}, place());
            break;
        case 3:
        case 4:
            w.drag(place(), place());
            break;
        case 5:
            w.dragTau(m_random.uniform(0, 1), m_random.uniform(0, 1), 5);
            break;
        case 6:
            turnWheel();
            break;
        case 7:
            choose();
            break;
        default:
            pressKey();
        }
        if (m_random.below(4) == 0)
            QTest::qWait(5); // the mission answers in between
    }

private:
    QPoint place()
    {
        return {static_cast<int>(m_random.uniform(0, w.map().width())),
                static_cast<int>(m_random.uniform(0, w.map().height()))};
    }

    void turnWheel()
    {
        const QPointF at = place();
        const int eighths = m_random.below(2) == 0 ? 120 : -120;
        QWheelEvent event(at, w.map().mapToGlobal(at), {}, QPoint(0, eighths), Qt::NoButton, {},
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&w.map(), &event);
    }

    void choose()
    {
        static const std::array kCombos{u"policyCombo"_s, u"solverCombo"_s, u"routeCombo"_s,
                                        u"rateCombo"_s};
        auto& combo = test::child<QComboBox>(w.window(), kCombos[m_random.below(kCombos.size())]);
        if (!combo.isEnabled())
            return;
        combo.setFocus();
        QTest::keyClick(&combo, m_random.below(2) == 0 ? Qt::Key_Down : Qt::Key_Up);
    }

    void pressKey()
    {
        struct Keys
        {
            Qt::Key key;
            Qt::KeyboardModifiers modifiers;
        };
        static constexpr std::array kKeys{Keys{Qt::Key_I, {}},
                                          Keys{Qt::Key_I, {}},
                                          Keys{Qt::Key_U, {}},
                                          Keys{Qt::Key_S, {}},
                                          Keys{Qt::Key_S, {}},
                                          Keys{Qt::Key_H, {}},
                                          Keys{Qt::Key_A, {}},
                                          Keys{Qt::Key_R, {}},
                                          Keys{Qt::Key_R, {}},
                                          Keys{Qt::Key_M, {}},
                                          Keys{Qt::Key_Backspace, {}},
                                          Keys{Qt::Key_C, Qt::ControlModifier},
                                          Keys{Qt::Key_V, Qt::ControlModifier},
                                          Keys{Qt::Key_D, Qt::ControlModifier},
                                          Keys{Qt::Key_F, {}},
                                          Keys{Qt::Key_L, {}},
                                          Keys{Qt::Key_Delete, {}},
                                          Keys{Qt::Key_Escape, {}},
                                          Keys{Qt::Key_Return, {}},
                                          Keys{Qt::Key_Left, {}},
                                          Keys{Qt::Key_Up, Qt::ShiftModifier},
                                          Keys{Qt::Key_A, Qt::ControlModifier},
                                          Keys{Qt::Key_Z, Qt::ControlModifier},
                                          Keys{Qt::Key_Z, Qt::ControlModifier},
                                          Keys{Qt::Key_Y, Qt::ControlModifier},
                                          Keys{Qt::Key_Space, {}},
                                          Keys{Qt::Key_Period, {}},
                                          Keys{Qt::Key_BracketRight, {}},
                                          Keys{Qt::Key_BracketLeft, {}},
                                          Keys{Qt::Key_Home, Qt::ControlModifier},
                                          Keys{Qt::Key_Home, Qt::ControlModifier}};
        const Keys keys = kKeys[m_random.below(kKeys.size())];
        w.map().setFocus();
        QTest::keyClick(&w.map(), keys.key, keys.modifiers);
    }

    WindowFixture& w;
    Random m_random;
};

} // namespace

/** Whatever is done, in whatever order, the scenario stays valid and every step can be undone. */
class TestMainWindowAny : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void anythingCanBeUndone_data()
    {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 4; ++seed)
            QTest::addRow("user %d", seed) << seed;
    }

    void anythingCanBeUndone()
    {
        QFETCH(int, seed);
        constexpr int kActs = 200;
        const Scenario start = randomScenario(seed, {.icebergs = 6});
        WindowFixture w(start);
        AnyUser user(w, static_cast<std::uint64_t>(seed));
        for (int i = 0; i < kActs; ++i) {
            const Scenario before = w.scenario();
            const bool wasInFlight = w.workspace.inFlight();
            user.act();
            if (wasInFlight && w.workspace.inFlight())
                QVERIFY(w.scenario() == before);
        }
        QVERIFY(!hasErrors(validate(w.scenario())));
        w.trigger(u"resetAction"_s);
        QVERIFY(w.untilReady());
        const Scenario end = w.scenario();
        int undone = 0;
        for (; w.document().undoStack()->canUndo(); ++undone)
            w.trigger(u"undoAction"_s);
        QVERIFY(w.scenario() == start);
        for (; undone > 0; --undone)
            w.trigger(u"redoAction"_s);
        QVERIFY(w.scenario() == end);
        QVERIFY(w.untilReady());
        const Plan plan = test::elsewhere([&] { return planFromStart(end); });
        QCOMPARE(w.record().now.plan->uavs[0].order, plan.uavs[0].order);
        QVERIFY(w.interaction.errors.isEmpty());
    }
};

QTEST_MAIN(TestMainWindowAny)
#include "tst_main_window_any.moc"
