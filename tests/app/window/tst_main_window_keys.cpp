#include "core/presets/presets.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSet>
#include <QTableView>
#include <QUndoStack>

#include <map>
#include <set>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

/** The actions of a menu and those below it; separators left out. */
QList<QAction*> actionsOf(const QWidget& menu)
{
    QList<QAction*> all;
    for (QAction* action : menu.actions()) {
        if (action->isSeparator())
            continue;
        if (action->menu() != nullptr)
            all << actionsOf(*action->menu());
        else
            all << action;
    }
    return all;
}

/** Returns the letter after the ampersand, or a null character without one. */
QChar mnemonicOf(const QString& text)
{
    const QKeySequence keys = QKeySequence::mnemonic(text);
    return keys.isEmpty() ? QChar() : QChar(keys[0].key()).toLower();
}

/** Returns the problem with the letters of this menu; empty if there is none. */
QString mnemonicFault(const QWidget& menu)
{
    std::map<QChar, QString> taken;
    for (const QAction* action : menu.actions()) {
        if (action->isSeparator())
            continue;
        const QChar letter = mnemonicOf(action->text());
        if (!letter.isNull() && !taken.emplace(letter, action->text()).second)
            return u"%1 and %2"_s.arg(taken[letter], action->text());
        if (action->menu() != nullptr)
            if (const QString fault = mnemonicFault(*action->menu()); !fault.isEmpty())
                return fault;
    }
    return {};
}

void raise(WindowFixture& w, const QString& dock)
{
    test::child<QDockWidget>(w.window(), dock);
    w.window().findChild<QDockWidget*>(dock)->raise();
    QTest::qWait(0);
}

/** State of the window that single-key shortcuts change. */
auto stateOf(WindowFixture& w)
{
    return std::tuple(
        w.scenario().icebergs.size(), w.workspace.selection().ids(), w.map().tools().kind(),
        w.map().camera().followsUav(), w.map().view().scale_pxpm(), w.record().now.generation,
        w.workspace.inFlight(), test::child<QComboBox>(w.window(), u"rateCombo"_s).currentIndex(),
        w.interaction.informations.size());
}

} // namespace

/** The window by keyboard. */
class TestMainWindowKeys : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    /** While a field has the focus all that writes is its own; Esc leaves it for the map. */
    void fieldsKeepTheirKeysUntilEscape()
    {
        WindowFixture w(randomScenario(1, {.icebergs = 4}));
        const double before = w.scenario().planner.tau;
        auto& tau = test::child<QAbstractSpinBox>(w.window(), u"tauField"_s);
        tau.setFocus();
        tau.selectAll();
        QTest::keyClicks(&tau, u"0.9"_s);
        QTest::keyClick(&tau, Qt::Key_Z, Qt::ControlModifier); // of the typing
        QCOMPARE(w.scenario().planner.tau, before);
        tau.selectAll();
        QTest::keyClicks(&tau, u"0.9"_s);
        QTest::keyClick(&tau, Qt::Key_Return);
        QCOMPARE(w.scenario().planner.tau, 0.9);
        QTest::keyClick(&tau, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(w.scenario().planner.tau, before);
        QVERIFY(w.untilReady());
        QTest::keyClick(&tau, Qt::Key_Space);
        QVERIFY(!w.workspace.inFlight());
        QTest::keyClick(&tau, Qt::Key_Escape);
        QCOMPARE(QApplication::focusWidget(), &w.map());
        QTest::keyClick(&w.map(), Qt::Key_Space);
        QVERIFY(w.until([&] { return w.workspace.isPlaying(); }));
        QVERIFY(!tau.text().isEmpty());
    }

    void escapeLeavesTheInspectorForTheMap_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("line") << u"icebergId"_s;
        QTest::newRow("number") << u"icebergEast"_s;
        QTest::newRow("coordinate") << u"icebergLatitude"_s;
    }

    void escapeLeavesTheInspectorForTheMap()
    {
        QFETCH(QString, name);
        WindowFixture w(randomScenario(1, {.icebergs = 4}));
        w.workspace.selection().set({w.scenario().icebergs[0].id});
        raise(w, u"inspectorDock"_s);
        auto& field = test::child<QWidget>(w.window(), name);
        field.setFocus();
        QTest::keyClicks(&field, u"1"_s);
        QTest::keyClick(&field, Qt::Key_Escape);
        QVERIFY(field.hasFocus()); // it is being typed
        QTest::keyClick(&field, Qt::Key_Z, Qt::ControlModifier);
        QTest::keyClick(&field, Qt::Key_Return);
        QTest::keyClick(&field, Qt::Key_Escape);
        QVERIFY(w.map().hasFocus());
    }

    void undoInAFieldIsOfItsTypingOrOfTheScenario_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("line") << u"name"_s;
        QTest::newRow("page") << u"notes"_s;
    }

    void undoInAFieldIsOfItsTypingOrOfTheScenario()
    {
        QFETCH(QString, name);
        WindowFixture w(randomScenario(1, {.icebergs = 4}));
        const Scenario before = w.scenario();
        const QUndoStack& history = *w.document().undoStack();
        raise(w, u"inspectorDock"_s);
        auto& field = test::child<QWidget>(w.window(), name);
        field.setFocus();
        QTest::keyClicks(&field, u"ab"_s);
        w.map().setFocus();
        QCOMPARE(history.index(), 1);
        field.setFocus();
        QTest::keyClick(&field, Qt::Key_Z, Qt::ControlModifier); // it was taken
        QCOMPARE(history.index(), 0);
        QVERIFY(w.scenario() == before);

        QTest::keyClicks(&field, u"w"_s);
        QCOMPARE(history.index(), 1);
        QTest::keyClick(&field, Qt::Key_Z, Qt::ControlModifier);
        QTest::keyClick(&field, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(w.scenario() == before);
        QCOMPARE(history.count(), 0); // "w" never was
    }

    void afterATimeTheKeysAreThoseOfTheFlight()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        auto& time = test::child<QLineEdit>(w.window(), u"timeField"_s);
        time.setFocus();
        QTest::keyClicks(&time, u"0:05"_s);
        QTest::keyClick(&time, Qt::Key_Return);
        QVERIFY(QApplication::focusWidget() != &time);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
        QTRY_VERIFY(w.workspace.inFlight());
    }

    void everyActionIsInAMenu()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const QList<QAction*> inMenus = actionsOf(*w.window().menuBar());
        QVERIFY(inMenus.size() > 25);
        for (const QAction* action : w.window().findChildren<QAction*>())
            if (!action->objectName().isEmpty() &&
                !action->objectName().startsWith(u"_q_"_s)) // Qt's own, e.g. to clear a field
                QVERIFY2(inMenus.contains(action), qPrintable(action->objectName()));
        for (const QAction* menu : w.window().menuBar()->actions())
            QVERIFY2(!mnemonicOf(menu->text()).isNull(), qPrintable(menu->text()));
    }

    void mnemonicsAreUnique_data()
    {
        QTest::addColumn<QString>("language");
        QTest::newRow("Danish") << u"da"_s;
        QTest::newRow("English") << u"en"_s;
        QTest::newRow("French") << u"fr"_s;
        QTest::newRow("Norwegian") << u"nb"_s;
    }

    void mnemonicsAreUnique()
    {
        QFETCH(QString, language);
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.trigger(u"view/language-"_s + language);
        QTest::qWait(0); // another window
        QCOMPARE(mnemonicFault(*w.window().menuBar()), QString());
        w.trigger(u"view/language-en"_s);
        QTest::qWait(0);
    }

    void noTwoActionsShareAShortcut()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        std::map<QString, const QAction*> taken;
        for (const QAction* action : w.window().findChildren<QAction*>())
            for (const QKeySequence& keys : action->shortcuts()) {
                const auto [other, isNew] = taken.emplace(keys.toString(), action);
                const bool ofCharts = // of the one that has the focus
                    action->shortcutContext() == Qt::WidgetShortcut &&
                    other->second->shortcutContext() == Qt::WidgetShortcut;
                QVERIFY2(isNew || ofCharts,
                         qPrintable(u"%1: %2 and %3"_s.arg(keys.toString(), action->text(),
                                                           other->second->text())));
            }
        QVERIFY(taken.size() >= 20);
    }

    void manualNamesKeysThatExist_data()
    {
        QTest::addColumn<QString>("language");
        QTest::newRow("English") << u"en"_s;
        QTest::newRow("Norwegian") << u"nb"_s;
    }

    void manualNamesKeysThatExist()
    {
        QFETCH(QString, language);
        WindowFixture w(test::MapFixture::fourIcebergs());
        QSet<QString> keys{u"Shift+F10"_s}; // of no command
        for (const QAction* action : w.window().findChildren<QAction*>())
            for (const QKeySequence& key : action->shortcuts())
                keys << key.toString();
        const QRegularExpression named(
            uR"(\*\*((?:(?:Ctrl|Alt|Shift)\+)+\w+|[A-Z]|F\d+)\*\*|\(((?:Ctrl\+)+\w|F\d+)\))"_s);
        int count = 0;
        const QDir pages(u":/manual/"_s + language);
        for (const QString& name : pages.entryList()) {
            QFile page(pages.filePath(name));
            QVERIFY(page.open(QIODevice::ReadOnly));
            const QString text = QString::fromUtf8(page.readAll());
            for (const QRegularExpressionMatch& match : named.globalMatch(text)) {
                const QString key = match.captured(1) + match.captured(2);
                QVERIFY2(keys.contains(key), qPrintable(name + u": "_s + key));
                ++count;
            }
        }
        QVERIFY(count >= 20);
    }

    void lettersTakeTools_data()
    {
        QTest::addColumn<Qt::Key>("key");
        QTest::addColumn<MapToolKind>("tool");
        QTest::newRow("I") << Qt::Key_I << MapToolKind::Iceberg;
        QTest::newRow("U") << Qt::Key_U << MapToolKind::Uav;
        QTest::newRow("A") << Qt::Key_A << MapToolKind::Asset;
        QTest::newRow("R") << Qt::Key_R << MapToolKind::Area;
        QTest::newRow("M") << Qt::Key_M << MapToolKind::Measure;
        QTest::newRow("H") << Qt::Key_H << MapToolKind::Pan;
        QTest::newRow("S") << Qt::Key_S << MapToolKind::Select;
    }

    /** From the map and from the list of the plan. */
    void lettersTakeTools()
    {
        QFETCH(Qt::Key, key);
        QFETCH(MapToolKind, tool);
        WindowFixture w(test::MapFixture::fourIcebergs());
        auto& plan = test::child<QTableView>(w.window(), u"planTable"_s);
        for (QWidget* focused : {static_cast<QWidget*>(&w.map()), static_cast<QWidget*>(&plan)}) {
            w.map().tools().setKind(tool == MapToolKind::Pan ? MapToolKind::Uav : MapToolKind::Pan);
            focused->setFocus();
            QTest::keyClick(focused, key);
            QCOMPARE(w.map().tools().kind(), tool);
        }
    }

    void keysMoveTheView()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.map().setFocus();
        const double fitted_pxpm = w.map().view().scale_pxpm();
        QTest::keyClick(&w.map(), Qt::Key_Plus, Qt::ControlModifier);
        QVERIFY(w.map().view().scale_pxpm() > fitted_pxpm);
        QTest::keyClick(&w.map(), Qt::Key_F);
        QCOMPARE(w.map().view().scale_pxpm(), fitted_pxpm);
        QTest::keyClick(&w.map(), Qt::Key_L);
        QVERIFY(w.map().camera().followsUav());
        QVERIFY(w.action(u"followAction"_s).isChecked());
        w.map().camera().panBy({300, 0}); // by hand: ends it
        QVERIFY(!w.action(u"followAction"_s).isChecked());
        QTest::keyClick(&w.map(), Qt::Key_Question);
        QCOMPARE(w.interaction.informations.size(), 1);
        QVERIFY(w.interaction.informations.front().contains(u"Ctrl+S"_s));
    }

    void typingIsNotTakenAway_data()
    {
        QTest::addColumn<QString>("dock");
        QTest::addColumn<QString>("selected");
        QTest::newRow("trade-off") << u"tradeoffDock"_s << QString();
        QTest::newRow("scenario") << u"inspectorDock"_s << QString();
        QTest::newRow("iceberg") << u"inspectorDock"_s << u"berg-2"_s;
        QTest::newRow("UAV") << u"inspectorDock"_s << u"uav-1"_s;
    }

    /** Every key that is a shortcut by itself, in every field that is typed in. */
    void typingIsNotTakenAway()
    {
        QFETCH(QString, dock);
        QFETCH(QString, selected);
        WindowFixture w(test::MapFixture::fourIcebergs());
        if (!selected.isEmpty())
            w.workspace.selection().set({selected.toStdString()});
        raise(w, dock);
        const auto before = stateOf(w);
        int fields = 0;
        for (QLineEdit* field : w.window().findChildren<QLineEdit*>()) {
            if (field->visibleRegion().isEmpty() || field->isReadOnly())
                continue;
            ++fields;
            auto* number = qobject_cast<QAbstractSpinBox*>(field->parentWidget());
            QWidget* input = number != nullptr ? static_cast<QWidget*>(number) : field;
            const QString text = field->text();
            input->setFocus();
            for (const char key :
                 {'s', 'i', 'u', 'a', 'r', 'm', 'h', 'f', 'l', ' ', '[', ']', '.', '?'}) {
                field->setText(text);
                field->end(false);
                QTest::keyClick(input, key);
                QVERIFY2(stateOf(w) == before, qPrintable(field->objectName() + QLatin1Char(key)));
                if (number == nullptr)
                    QCOMPARE(field->text(), text + QLatin1Char(key));
            }
            field->selectAll();
            QTest::keyClick(input, Qt::Key_Delete);
            QVERIFY(stateOf(w) == before);
            QTest::keyClick(input, Qt::Key_A, Qt::ControlModifier);
            QVERIFY(stateOf(w) == before);
            field->setText(text);
        }
        QVERIFY(fields >= (dock == u"tradeoffDock"_s ? 1 : 3));
    }

    /** The brackets go through the rates of the list, one by one. */
    /** Behind another tab a field would be changed unseen. */
    void tabStaysInSight()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.workspace.selection().set({"berg-1"});
        for (const char* layout : {"planLayoutAction", "analyseLayoutAction"})
            w.trigger(QLatin1String(layout)); // tab bars come and go
        for (const QString& dock : {u"planDock"_s, u"inspectorDock"_s}) {
            raise(w, dock);
            w.map().setFocus();
            QSet<QWidget*> seen;
            for (const Qt::Key key : {Qt::Key_Tab, Qt::Key_Backtab})
                for (int i = 0; i < 150; ++i) {
                    QTest::keyClick(QApplication::focusWidget(), key);
                    QWidget* focused = QApplication::focusWidget();
                    QVERIFY(focused != nullptr);
                    seen << focused;
                    const QWidget* at = focused;
                    while (at != nullptr && qobject_cast<const QDockWidget*>(at) == nullptr)
                        at = at->parentWidget();
                    QVERIFY2(at == nullptr || !at->visibleRegion().isEmpty(),
                             qPrintable(focused->objectName()));
                    if (focused->parentWidget() == &w.window()) // a tab bar may be kept outside
                        QVERIFY(w.window().rect().intersects(focused->geometry()));
                }
            QVERIFY(seen.contains(&w.map()));
            QVERIFY(seen.size() > 10);
            auto* field = &test::child<QWidget>(w.window(), u"icebergs.sigma0_m2"_s);
            QCOMPARE(seen.contains(field), dock == u"inspectorDock"_s);
        }
    }

    void focusDoesNotStayBehindATab()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.workspace.selection().set({"berg-1"});
        raise(w, u"inspectorDock"_s);
        auto& field = test::child<QWidget>(w.window(), u"icebergs.sigma0_m2"_s);
        field.setFocus();
        QVERIFY(field.hasFocus());
        raise(w, u"planDock"_s);
        QTRY_COMPARE(QApplication::focusWidget(), &w.map());
    }

    void bracketsTakeEveryRate()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        auto& rate = test::child<QComboBox>(w.window(), u"rateCombo"_s);
        rate.setCurrentIndex(0);
        w.map().setFocus();
        for (int i = 1; i < rate.count(); ++i) {
            QTest::keyClick(&w.map(), Qt::Key_BracketRight);
            QCOMPARE(rate.currentIndex(), i);
        }
        QTest::keyClick(&w.map(), Qt::Key_BracketRight);
        QCOMPARE(rate.currentIndex(), rate.count() - 1);
        for (int i = rate.count() - 2; i >= 0; --i) {
            QTest::keyClick(&w.map(), Qt::Key_BracketLeft);
            QCOMPARE(rate.currentIndex(), i);
        }
    }

    void spaceOpensTheListWithTheFocus_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"policyCombo", "solverCombo", "routeCombo", "rateCombo"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }

    void spaceFliesAfterAChoiceByMouse_data() { spaceOpensTheListWithTheFocus_data(); }

    /** The keys work as the status bar describes them. */
    void spaceFliesAfterAChoiceByMouse()
    {
        QFETCH(QString, name);
        WindowFixture w(test::MapFixture::fourIcebergs());
        auto& combo = test::child<QComboBox>(w.window(), name);
        w.map().setFocus();
        QTest::mouseClick(&combo, Qt::LeftButton);
        QTRY_VERIFY(combo.view()->isVisible());
        const int before = combo.currentIndex();
        QTest::keyClick(combo.view(), before == 0 ? Qt::Key_Down : Qt::Key_Up);
        QTest::keyClick(combo.view(), Qt::Key_Return);
        QTRY_VERIFY(!combo.view()->isVisible());
        QVERIFY(combo.currentIndex() != before);
        w.window().activateWindow(); // there is no window manager that does
        QVERIFY(QTest::qWaitForWindowActive(&w.window()));
        QCOMPARE(QApplication::focusWidget(), &w.map());
        QVERIFY(w.untilReady());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
        QTRY_VERIFY(w.workspace.inFlight());
        QVERIFY(!combo.view()->isVisible());
    }

    /** It does not take off. */
    void spaceOpensTheListWithTheFocus()
    {
        QFETCH(QString, name);
        WindowFixture w(test::MapFixture::fourIcebergs());
        auto& combo = test::child<QComboBox>(w.window(), name);
        combo.setFocus();
        QTest::keyClick(&combo, Qt::Key_Space);
        QVERIFY(combo.view()->isVisible());
        combo.hidePopup();
        QTest::qWait(100);
        QCOMPARE(w.record().now.phase, RunPhase::Ready);
    }

    void spacePressesTheButtonWithTheFocus()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        auto& step = test::child<QAbstractButton>(w.window(), u"stepButton"_s);
        step.setFocus();
        QTest::keyClick(&step, Qt::Key_Space);
        QVERIFY(w.until([&] { return w.workspace.inFlight(); }));
        QCOMPARE(w.record().now.phase, RunPhase::Paused); // one second flown
    }
};

QTEST_MAIN(TestMainWindowKeys)
#include "tst_main_window_keys.moc"
