#include "core/base/random.h"
#include "core/io/files/scenario_json.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/document/recovery_store.h"
#include "widgets/panels/inspector/inspector_panel.h"

#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QListWidget>
#include <QPointer>
#include <QStatusBar>

#include <array>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

/** Somebody who types anything into the inspector and drags anything anywhere. */
class AnyEditor
{
public:
    AnyEditor(WindowFixture& w, std::uint64_t seed) : m_w(w), m_random(seed, 23) {}

    void edit()
    {
        select();
        if (m_random.below(4) == 0)
            drag();
        else
            fill();
    }

private:
    [[nodiscard]] QPoint anywhere()
    {
        return {static_cast<int>(m_random.below(static_cast<std::uint64_t>(m_w.map().width()))),
                static_cast<int>(m_random.below(static_cast<std::uint64_t>(m_w.map().height())))};
    }
    void select()
    {
        const Scenario& scenario = m_w.scenario();
        std::vector<std::string> ids{"", kAssetKey, kAreaKey};
        for (const Uav& uav : scenario.uavs)
            ids.push_back(uav.id);
        for (const Iceberg& iceberg : scenario.icebergs)
            ids.push_back(iceberg.id);
        const std::string id = ids[m_random.below(ids.size())];
        m_w.workspace.selection().set(id.empty() ? std::vector<std::string>()
                                                 : std::vector<std::string>{id});
        m_w.workspace.selection().keepExisting(scenario);
    }
    void drag()
    {
        static constexpr std::array kTools{MapToolKind::Select, MapToolKind::Iceberg,
                                           MapToolKind::Uav,    MapToolKind::Asset,
                                           MapToolKind::Area,   MapToolKind::NoFly};
        m_w.map().tools().setKind(kTools[m_random.below(kTools.size())]);
        const Scenario& scenario = m_w.scenario();
        const QPoint from =
            m_random.below(3) == 0
                ? anywhere()
                : m_w.pixelOf(scenario.uavs[m_random.below(scenario.uavs.size())].position_m);
        if (m_w.scenario().icebergs.size() < 10)
            m_w.drag(from, anywhere());
        m_w.map().tools().setKind(MapToolKind::Select);
    }
    [[nodiscard]] QString anyText()
    {
        static const QStringList kTexts{
            u"0"_s,      u"-1"_s,    u"0.01"_s,    u"1"_s,
            u"3.7"_s,    u"60"_s,    u"1000"_s,    u"999999"_s,
            u"604800"_s, u"1e9"_s,   u""_s,        u"berg-1"_s,
            u"ø"_s,      u"10000"_s, u"-999999"_s, u"2024-05-01T06:00:00Z"_s};
        return kTexts[static_cast<qsizetype>(
            m_random.below(static_cast<std::uint64_t>(kTexts.size())))];
    }
    void fill()
    {
        auto* panel = m_w.window().findChild<InspectorPanel*>();
        QList<QWidget*> inputs;
        for (QWidget* input : panel->findChildren<QWidget*>())
            if (input->isVisibleTo(panel) && input->isEnabled() &&
                (qobject_cast<QAbstractSpinBox*>(input) != nullptr ||
                 qobject_cast<QCheckBox*>(input) != nullptr ||
                 qobject_cast<QComboBox*>(input) != nullptr ||
                 (qobject_cast<QLineEdit*>(input) != nullptr && input->focusProxy() == nullptr)))
                inputs << input;
        QWidget* input = inputs[static_cast<qsizetype>(
            m_random.below(static_cast<std::uint64_t>(inputs.size())))];
        if (auto* box = qobject_cast<QCheckBox*>(input)) {
            box->click();
        } else if (auto* list = qobject_cast<QComboBox*>(input)) {
            list->setCurrentIndex(
                static_cast<int>(m_random.below(static_cast<std::uint64_t>(list->count()))));
            emit list->activated(list->currentIndex());
        } else {
            test::enter(*input, anyText());
        }
    }

    WindowFixture& m_w;
    Random m_random;
};

} // namespace

/** Whatever the window saves it opens again, if it can be flown or not. */
class TestMainWindowSaved : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void titleNamesFileAndScenario()
    {
        Scenario scenario = test::MapFixture::fourIcebergs();
        scenario.name = "Grand Banks";
        WindowFixture w(scenario);
        QCOMPARE(w.window().windowTitle(), u"Untitled[*] - Grand Banks - Bergwatch"_s);
        w.interaction.path = w.file(u"mine.berg"_s);
        w.trigger(u"saveAsAction"_s);
        QCOMPARE(w.window().windowTitle(), u"mine.berg[*] - Grand Banks - Bergwatch"_s);
        QVERIFY(!w.window().isWindowModified());
        w.document().edit(u"Name"_s, [](Scenario& s) { s.name.clear(); });
        QCOMPARE(w.window().windowTitle(), u"mine.berg[*] - Bergwatch"_s);
        QVERIFY(w.window().isWindowModified());
    }

    /** A day of flight takes a second to read: the window lives meanwhile. */
    void runsAreReadAndWrittenOnAnotherThread()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.workspace.stepTicks(50);
        QVERIFY(w.until([&] { return w.workspace.isMidFlight(); }));
        w.interaction.path = w.file(u"a.bergrun"_s);
        w.trigger(u"saveRunAction"_s);
        QTRY_COMPARE(w.interaction.waits, QStringList{u"Saving a.bergrun"_s});
        QVERIFY(!w.interaction.mayCancelWaits.back());
        w.workspace.reset();
        QVERIFY(w.untilReady());
        QVERIFY(w.window().parts().files.openFile(w.interaction.path));
        QCOMPARE(w.interaction.waits.back(), u"Reading a.bergrun"_s);
        QVERIFY(w.interaction.mayCancelWaits.back());
        QVERIFY(w.until([&] { return w.workspace.isMidFlight(); }));
        QVERIFY(w.interaction.errors.isEmpty());
    }

    /** A part of it goes on when the wait is over. */
    void windowIsNotMadeAnewWhileItWaits()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.workspace.stepTicks(50);
        QVERIFY(w.until([&] { return w.workspace.isMidFlight(); }));
        w.interaction.path = w.file(u"a.bergrun"_s);
        const QPointer<MainWindow> window(&w.window());
        bool wasThere = false;
        w.interaction.whileWaiting = [&] {
            emit window->unitsChosen();
            QCoreApplication::sendPostedEvents();
            wasThere = !window.isNull();
        };
        w.trigger(u"saveRunAction"_s);
        QTRY_VERIFY(wasThere);
        QTRY_VERIFY(window.isNull());
        QVERIFY(w.window().isVisible());
    }

    void anyEditOpensAgain_data()
    {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 6; ++seed)
            QTest::addRow("seed %d", seed) << seed;
    }

    void anyEditOpensAgain()
    {
        QFETCH(int, seed);
        Scenario start = test::MapFixture::fourIcebergs();
        start.area_m = {{-500, -500}, {2000, -500}, {2000, 1500}, {-500, 1500}};
        start.geofence = true;
        start.asset = Asset{};
        start.observer.model = ObserverModel::Kalman;
        WindowFixture w(start);
        AnyEditor editor(w, static_cast<std::uint64_t>(seed));
        const QString path = w.file(u"any.berg"_s);
        w.interaction.path = path;
        w.interaction.overwrite = Interaction::Overwrite::Overwrite;
        int faulty = 0;
        for (int i = 0; i < 180; ++i) {
            editor.edit();
            faulty += hasErrors(w.document().issues()) ? 1 : 0;
            if (i % 6 != 5)
                continue;
            w.trigger(u"saveAction"_s);
            QCOMPARE(w.interaction.errors, QStringList());
            QVERIFY(w.document().isClean());
            const Scenario saved = w.scenario();
            QVERIFY(loadScenario(path.toStdString(), ScenarioUse::Editing) == saved);
            if (i % 30 != 29)
                continue;
            QVERIFY(w.window().parts().files.openFile(path));
            QVERIFY(w.scenario() == saved);
        }
        QVERIFY2(faulty > 0, "nothing was tried that cannot be flown");
    }

    void uavOutsideTheGeofenceIsOpenedAndNotFlown()
    {
        Scenario start = test::MapFixture::fourIcebergs();
        start.area_m = {{-500, -500}, {4500, -500}, {4500, 3500}, {-500, 3500}};
        start.geofence = true;
        WindowFixture w(start);
        w.workspace.autosaver().start(w.file(u"recovery"_s), {.pause_ms = 0, .longest_ms = 0});
        w.map().camera().zoomBy(0.7, QRectF(w.map().rect()).center());
        w.drag(w.pixelOf(Point(0, 0)), w.pixelOf(Point(-800, 1500)));
        QVERIFY(w.scenario().uavs[0].position_m.x() < -700);
        QVERIFY(w.until(RunPhase::Failed));
        w.workspace.autosaver().keep();
        QCOMPARE(QDir(w.file(u"recovery"_s)).entryList({u"*.berg"_s}).size(), 1);

        w.interaction.path = w.file(u"outside.berg"_s);
        w.trigger(u"saveAction"_s);
        const Scenario saved = w.scenario();
        w.document().reset(test::MapFixture::fourIcebergs());
        QVERIFY(w.window().parts().files.openFile(w.interaction.path));
        QCOMPARE(w.interaction.errors, QStringList());
        QVERIFY(w.scenario() == saved);
        QVERIFY(w.until(RunPhase::Failed));
        w.trigger(u"checksAction"_s);
        QVERIFY(test::child<QListWidget>(w.window(), u"checkList"_s).count() > 0);
        w.trigger(u"playAction"_s);
        w.trigger(u"undoAction"_s);
        QTest::qWait(50);
        QVERIFY(!w.workspace.inFlight());
        w.drag(w.pixelOf(saved.uavs[0].position_m), w.pixelOf(Point(500, 1500)));
        QVERIFY(w.untilReady());
    }
};

QTEST_MAIN(TestMainWindowSaved)
#include "tst_main_window_saved.moc"
