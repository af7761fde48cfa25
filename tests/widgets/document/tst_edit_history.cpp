#include "core/base/random.h"
#include "core/checks/validate.h"
#include "core/presets/presets.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/random_edits.h"

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/** The expected undo stack: the scenario after each step. */
class History
{
public:
    explicit History(const ScenarioDocument& document)
        : m_document(document), m_states{document.scenario()}
    {
    }

    /** Records an edit; the steps that could be redone are dropped. */
    void noteEdit()
    {
        const auto index = static_cast<std::size_t>(m_document.undoStack()->index());
        const bool isSame = index < m_states.size() && m_states[index] == m_document.scenario();
        if (!isSame) {
            m_states.resize(index);
            m_states.push_back(m_document.scenario());
        } else if (!m_document.undoStack()->canRedo()) {
            m_states.resize(index + 1);
        }
    }

    /** Returns whether the scenario is the one recorded for the present step. */
    [[nodiscard]] bool isRight() const
    {
        const auto index = static_cast<std::size_t>(m_document.undoStack()->index());
        return index < m_states.size() && m_states[index] == m_document.scenario() &&
               m_states.size() == static_cast<std::size_t>(m_document.undoStack()->count()) + 1;
    }

private:
    const ScenarioDocument& m_document;
    std::vector<Scenario> m_states;
};

/** Undoes and redoes everything; returns whether the scenario is right at every step. */
bool undoesAndRedoes(ScenarioDocument& document, const History& history)
{
    QUndoStack& stack = *document.undoStack();
    bool isRight = true;
    while (stack.canUndo() && isRight) {
        stack.undo();
        isRight = history.isRight();
    }
    while (stack.canRedo() && isRight) {
        stack.redo();
        isRight = history.isRight();
    }
    return isRight;
}

} // namespace

/** Any edit can be undone and redone exactly, step by step. */
class TestEditHistory : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        QTest::failOnWarning(
            QRegularExpression(u"^(?!This plugin does not support propagateSizeHints)"_s));
    }

    void everyStepComesBack_data()
    {
        QTest::addColumn<int>("seed");
        QTest::addColumn<bool>("interleaved");
        for (int seed = 1; seed <= 3; ++seed) {
            QTest::addRow("seed %d", seed) << seed << false;
            QTest::addRow("seed %d, undo and redo in between", seed) << seed << true;
        }
    }

    void everyStepComesBack()
    {
        QFETCH(int, seed);
        QFETCH(bool, interleaved);
        constexpr int kEdits = 2000;
        test::MapFixture map;
        map.document.undoStack()->clear();
        map.document.undoStack()->setUndoLimit(0);
        test::RandomEdits edits(map, static_cast<std::uint64_t>(seed));
        Random random(static_cast<std::uint64_t>(seed), 31);
        History history(map.document);
        for (int i = 0; i < kEdits; ++i) {
            if (interleaved && random.below(4) == 0) {
                map.document.endGesture();
                for (std::uint64_t n = random.below(6); n > 0; --n)
                    map.document.undoStack()->undo();
                for (std::uint64_t n = random.below(4); n > 0; --n)
                    map.document.undoStack()->redo();
                QVERIFY2(history.isRight(), QByteArray::number(i).constData());
            }
            const QString what = edits.edit();
            history.noteEdit();
            QVERIFY2(history.isRight(), qPrintable(what));
            QVERIFY2(!hasErrors(map.document.issues()), qPrintable(what));
        }
        QVERIFY(map.undoCount() > (interleaved ? 50 : kEdits / 3));
        QVERIFY(undoesAndRedoes(map.document, history));
        QCOMPARE(edits.kindsMissing(), QStringList());
    }

    /** A history beyond its limit loses its beginning, never its order. */
    void theOldestStepsAreForgotten()
    {
        test::MapFixture map;
        QUndoStack& stack = *map.document.undoStack();
        const int limit = stack.undoLimit();
        QVERIFY(limit >= 1000);
        for (int i = 1; i <= limit + 5; ++i)
            map.document.edit(u"Tau"_s, [i](Scenario& s) { s.planner.tau = 0.01 * i; });
        QCOMPARE(stack.count(), limit);
        while (stack.canUndo())
            stack.undo();
        QCOMPARE(map.scenario().planner.tau, 0.05);
        while (stack.canRedo())
            stack.redo();
        QCOMPARE(map.scenario().planner.tau, 0.01 * (limit + 5));
    }
};

QTEST_MAIN(TestEditHistory)
#include "tst_edit_history.moc"
