#include "app/dialogs/interaction.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"

#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QFileDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QTableView>
#include <QTimer>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

/** One run in the list of the comparison, which has the focus; an iceberg is selected. */
struct ListWindow : WindowFixture
{
    QTableView* runs = nullptr;

    ListWindow() : WindowFixture(test::MapFixture::shortRun())
    {
        workspace.fly(kFastestRate);
        if (!until(RunPhase::Finished))
            qFatal("not flown");
        workspace.reset();
        if (!untilReady())
            qFatal("not planned");
        test::child<QDockWidget>(window(), u"comparisonDock"_s).raise();
        runs = &test::child<QTableView>(window(), u"comparedRuns"_s);
        workspace.selection().set({"berg-2"});
        runs->setFocus();
    }
    [[nodiscard]] std::size_t count() { return workspace.runs().runs().size(); }
};

} // namespace

/** Keys go to the list that has the focus, whatever they are to the window. */
class TestMainWindowLists : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void deleteInTheListOfRunsRemovesARun_data()
    {
        QTest::addColumn<bool>("inFlight");
        QTest::newRow("before take-off") << false;
        QTest::newRow("in flight") << true;
    }

    void deleteInTheListOfRunsRemovesARun()
    {
        QFETCH(bool, inFlight);
        ListWindow w;
        if (inFlight) {
            w.workspace.stepTicks(50);
            QVERIFY(w.until([&] { return w.workspace.isMidFlight(); }));
        }
        QCOMPARE(w.count(), 1U);
        QTest::keyClick(w.runs, Qt::Key_Delete);
        QCOMPARE(w.count(), 0U);
        QVERIFY(w.scenario() == test::MapFixture::shortRun());
        if (inFlight)
            QVERIFY(test::flownRun(w)->interventions.empty());
    }

    void lettersOfTheListOfRunsTakeNoTool()
    {
        ListWindow w;
        w.workspace.runs().addVariant(*w.workspace.runs().reference(),
                                      {.policy = PolicyKind::Nearest});
        QVERIFY(w.until([&] { return w.workspace.runs().comparison().has_value(); }));
        const RunPointer other = w.workspace.runs().other();
        w.runs->setCurrentIndex(w.runs->model()->index(1, 0));
        QTest::keyClick(w.runs, Qt::Key_A);
        QVERIFY(w.workspace.runs().reference() == other);
        QTest::keyClick(w.runs, Qt::Key_B);
        QVERIFY(w.workspace.runs().other() == other);
        QCOMPARE(w.map().tools().kind(), MapToolKind::Select);
    }

    void messagesAreCopied()
    {
        ListWindow w;
        auto& messages = test::child<QListWidget>(w.window(), u"messageList"_s);
        test::child<QDockWidget>(w.window(), u"messagesDock"_s).show();
        messages.addItem(u"hello"_s);
        messages.setCurrentRow(messages.count() - 1);
        messages.setFocus();
        QGuiApplication::clipboard()->clear();
        QTest::keyClick(&messages, Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QGuiApplication::clipboard()->text(), u"hello"_s);
    }

    /** Elsewhere the key ends the flight. */
    void firstRowIsReachedInEveryTable()
    {
        ListWindow w;
        const auto tables = w.window().findChildren<QTableView*>();
        QVERIFY(tables.size() >= 5);
        for (QTableView* table : tables) {
            if (table->focusPolicy() == Qt::NoFocus)
                continue;
            QKeyEvent key(QEvent::ShortcutOverride, Qt::Key_Home, Qt::ControlModifier);
            key.ignore();
            QCoreApplication::sendEvent(table, &key);
            QVERIFY2(key.isAccepted(), qPrintable(table->objectName()));
        }
        w.workspace.stepTicks(50);
        QVERIFY(w.until([&] { return w.workspace.isMidFlight(); }));
        test::child<QDockWidget>(w.window(), u"icebergsDock"_s).raise();
        auto& table = test::child<QTableView>(w.window(), u"icebergTable"_s);
        table.setFocus();
        table.setCurrentIndex(table.model()->index(2, 0));
        QTest::keyClick(&table, Qt::Key_Home, Qt::ControlModifier);
        QCOMPARE(table.currentIndex().row(), 0);
        QVERIFY(w.workspace.isMidFlight());
    }

    void arrowsPanInFlight()
    {
        ListWindow w;
        w.workspace.stepTicks(50);
        QVERIFY(w.until([&] { return w.workspace.isMidFlight(); }));
        w.map().setFocus();
        const Point before_m = w.map().toWorld(QPointF(0, 0));
        QTest::keyClick(&w.map(), Qt::Key_Left);
        QVERIFY(w.map().toWorld(QPointF(0, 0)).x() < before_m.x());
    }

    void typedNameGetsTheEndingThatIsChosen()
    {
        const QTemporaryDir folder;
        DialogInteraction interaction;
        QTimer::singleShot(0, [&] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            QVERIFY(dialog != nullptr);
            dialog->setDirectory(folder.path());
            auto& types = test::child<QComboBox>(*dialog, u"fileTypeCombo"_s);
            types.setFocus();
            QTest::keyClick(&types, Qt::Key_End);
            auto& name = test::child<QLineEdit>(*dialog, u"fileNameEdit"_s);
            name.setText(u"numbers"_s);
            QTest::keyClick(&name, Qt::Key_Return);
        });
        const QString path = interaction.savePath(nullptr, u"zeta.png"_s,
                                                  u"Picture (*.png);;Table of numbers (*.csv)"_s);
        QCOMPARE(QFileInfo(path).fileName(), u"numbers.csv"_s);
    }
};

QTEST_MAIN(TestMainWindowLists)
#include "tst_main_window_lists.moc"
