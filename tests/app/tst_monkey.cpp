#include "app/window/window_parts.h"
#include "core/presets/presets.h"
#include "tests/support/window/monkey.h"
#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"

using namespace berg;
using namespace Qt::StringLiterals;
using test::kPatience_ms;
using test::Monkey;
using test::MonkeyWindow;

namespace {

constexpr int kBurst = 50; ///< actions between two looks at everything

/** Returns the violated condition after an action; empty if all hold. */
QString faultNow(MonkeyWindow& w)
{
    const bool flies = w.workspace.inFlight();
    if (w.map().isLocked() != flies)
        return flies ? u"in flight the map is not locked"_s
                     : u"the map is locked while nothing flies"_s;
    return {};
}

/** Conditions on the scenario that hold after every edit. */
QString faultOf(const Scenario& scenario)
{
    try {
        if (scenarioFromJson(scenarioToJson(scenario), "monkey", ScenarioUse::Editing) != scenario)
            return u"the scenario comes back from JSON as another one"_s;
    } catch (const Error& error) {
        return u"the scenario as JSON cannot be read: "_s + QString::fromUtf8(error.what());
    }
    return {};
}

/** Ends the flight and places an iceberg as a user would: does the window still do it? */
QString faultOfUse(MonkeyWindow& w)
{
    if (!w.untilAnswered(kPatience_ms))
        return u"the mission does not answer"_s;
    w.workspace.reset();
    if (w.map().isLocked() || w.workspace.inFlight())
        return u"the end of a flight does not unlock the map"_s;
    if (w.window().parts().start.pageIsShown() || !w.map().isVisible())
        return {};
    w.map().camera().fit();
    w.map().tools().setKind(MapToolKind::Iceberg);
    const std::size_t before = w.scenario().icebergs.size();
    const QSize size = w.map().size();
    for (int i = 1; i < 36 && w.scenario().icebergs.size() == before; ++i)
        QTest::mouseClick(&w.map(), Qt::LeftButton, {},
                          {i % 6 * size.width() / 6, (i / 6 * 2 + 1) * size.height() / 12});
    w.map().tools().setKind(MapToolKind::Select);
    if (w.scenario().icebergs.size() != before + 1)
        return u"no iceberg can be placed"_s;
    QUndoStack& history = *w.document().undoStack();
    const QString step = history.undoText();
    history.undo();
    if (w.scenario().icebergs.size() == before + 1)
        history.undo(); // what was held when the monkey stopped ended as a step of its own
    return w.scenario().icebergs.size() == before
               ? QString()
               : u"undoing '%1' does not remove it: %2 of %3 icebergs"_s.arg(step)
                     .arg(w.scenario().icebergs.size())
                     .arg(before);
}

int numberFrom(const char* variable, int otherwise)
{
    bool isNumber = false;
    const int number = qEnvironmentVariableIntValue(variable, &isNumber);
    return isNumber ? number : otherwise;
}

Scenario firstScenario(std::uint64_t seed)
{
    return randomScenario(static_cast<std::int64_t>(seed), {.icebergs = 6});
}

/** One window and whoever uses it: what is looked at while it is used. */
class MonkeyRun
{
public:
    explicit MonkeyRun(std::uint64_t seed)
        : w(firstScenario(seed), seed), m_monkey(w, seed), m_start(w.scenario())
    {
        QObject::connect(&w.workspace, &Workspace::inFlightChanged, &m_context,
                         [this] { ++m_changes; });
        QObject::connect(&w.document(), &ScenarioDocument::replaced, &m_context, [this] {
            ++m_changes;
            m_start = w.scenario();
        });
    }

    /** Returns all actions up to the first fault; empty without a fault. */
    [[nodiscard]] QString go(int actions)
    {
        qInfo("actions are written to %s", qPrintable(m_monkey.logPath()));
        QString fault;
        for (int i = 0; i < actions && fault.isEmpty(); ++i) {
            fault = faultOfAction(i);
            if (fault.isEmpty() && (i + 1) % kBurst == 0)
                fault = faultOfBurst();
            if (!fault.isEmpty())
                fault = u"action %1: "_s.arg(i) + fault;
        }
        if (fault.isEmpty())
            fault = faultOfHistory();
        w.folder.setAutoRemove(fault.isEmpty());
        return fault;
    }

private:
    QString faultOfAction(int number)
    {
        const Scenario before = w.scenario();
        const bool wasInFlight = w.workspace.inFlight();
        const int changesBefore = m_changes;
        m_monkey.act(number);
        if (wasInFlight && m_changes == changesBefore && w.scenario() != before)
            return u"the scenario was changed in flight"_s;
        return faultNow(w);
    }

    QString faultOfBurst()
    {
        m_monkey.rest();
        for (const QString& fault : {faultNow(w), faultOf(w.scenario()), faultOfUse(w)})
            if (!fault.isEmpty())
                return fault;
        return {};
    }

    QString faultOfHistory()
    {
        m_monkey.rest();
        w.workspace.reset();
        QUndoStack& history = *w.document().undoStack();
        if (history.count() >= history.undoLimit())
            return {}; // the beginning is forgotten
        const Scenario end = w.scenario();
        const int steps = history.index();
        while (history.canUndo())
            history.undo();
        if (w.scenario() != m_start)
            return u"undo does not lead back to the start"_s;
        while (history.index() < steps)
            history.redo();
        return w.scenario() == end ? QString() : u"redo does not lead to the end"_s;
    }

    MonkeyWindow w;
    Monkey m_monkey;
    QObject m_context;
    Scenario m_start;  ///< what undo leads back to
    int m_changes = 0; ///< of what is flown or edited altogether
};

} // namespace

/**
 * The real window with its real dialogs, used by somebody who does anything at any time. With
 * BERGWATCH_MONKEY_SEED it is that seed alone, with BERGWATCH_MONKEY_ACTIONS so many actions of
 * each; BERGWATCH_MONKEY_SECONDS goes through seeds from there on until the time is up.
 */
class TestMonkey : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QDir::setCurrent(m_home.path()); }
    void init() { test::failOnWarnings(); }

    void randomUseFindsNoFault_data()
    {
        QTest::addColumn<int>("seed");
        // 12 presses on a corner of an area, undoes and drags on; 28 and 46 take off in a drag.
        QList<int> seeds{12, 28, 46, 1, 2, 3};
        if (qEnvironmentVariableIsSet("BERGWATCH_MONKEY_SEED"))
            seeds = {numberFrom("BERGWATCH_MONKEY_SEED", 1)};
        for (const int seed : seeds)
            QTest::addRow("seed %d", seed) << seed;
    }

    void randomUseFindsNoFault()
    {
        QFETCH(int, seed);
        MonkeyRun run(static_cast<std::uint64_t>(seed));
        const QString fault = run.go(numberFrom("BERGWATCH_MONKEY_ACTIONS", 250));
        QVERIFY2(fault.isEmpty(), qPrintable(fault));
    }

    void forLong()
    {
        const int patience_s = numberFrom("BERGWATCH_MONKEY_SECONDS", 0);
        if (patience_s == 0)
            QSKIP("for as long as BERGWATCH_MONKEY_SECONDS says");
        QElapsedTimer clock;
        clock.start();
        for (int seed = numberFrom("BERGWATCH_MONKEY_SEED", 1000);
             clock.elapsed() < qint64{1000} * patience_s; ++seed) {
            qInfo("seed %d", seed);
            MonkeyRun run(static_cast<std::uint64_t>(seed));
            const QString fault = run.go(numberFrom("BERGWATCH_MONKEY_ACTIONS", 300));
            QVERIFY2(fault.isEmpty(), qPrintable(u"seed %1: %2"_s.arg(seed).arg(fault)));
        }
    }

private:
    QTemporaryDir m_home;
};

int main(int argc, char** argv)
{
    if (!qEnvironmentVariableIsSet("QTEST_FUNCTION_TIMEOUT"))
        qputenv("QTEST_FUNCTION_TIMEOUT", "7200000"); // ms; ten minutes take more than ten minutes
    QTemporaryDir home; // nothing that is written by mistake ends up in the user's own
    qputenv("HOME", QFile::encodeName(home.path()));
    QApplication app(argc, argv);
    QApplication::setApplicationName(u"bergwatch"_s);
    TestMonkey test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_monkey.moc"
