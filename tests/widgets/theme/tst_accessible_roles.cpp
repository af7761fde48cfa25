#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"
#include "widgets/theme/accessible_roles.h"

#include <QAccessibleInterface>
#include <QAction>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QLabel>
#include <QListWidget>
#include <QScrollArea>
#include <QSignalSpy>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

QAccessibleInterface& interfaceOf(QWidget& widget)
{
    QAccessibleInterface* known = QAccessible::queryAccessibleInterface(&widget);
    if (known == nullptr)
        qFatal("no interface");
    return *known;
}

/** Painted by us, with a menu. */
class Painted : public QWidget
{
public:
    using QWidget::QWidget;
    int menus = 0;

protected:
    void contextMenuEvent(QContextMenuEvent* event) override
    {
        menus += event->reason() == QContextMenuEvent::Keyboard ? 1 : 0;
    }
};

} // namespace

class TestAccessibleRoles : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { installAccessibleRoles(); }
    void init() { test::failOnWarnings(); }

    void holdersAreGroups()
    {
        QWidget window;
        auto* inside = new QWidget(&window);
        auto* scroll = new QScrollArea(&window);
        auto* label = new QLabel(u"text"_s, &window);
        QCOMPARE(interfaceOf(window).role(), QAccessible::Window);
        QCOMPARE(interfaceOf(*inside).role(), QAccessible::Grouping);
        QCOMPARE(interfaceOf(*scroll).role(), QAccessible::Grouping);
        QCOMPARE(interfaceOf(*label).role(), QAccessible::StaticText); // as Qt has it
    }

    void roleMayComeLater()
    {
        Painted chart;
        QCOMPARE(interfaceOf(chart).role(), QAccessible::Window);
        setAccessibleRole(chart, QAccessible::Chart);
        chart.setAccessibleName(u"Zeta"_s);
        QCOMPARE(interfaceOf(chart).role(), QAccessible::Chart);
        QCOMPARE(interfaceOf(chart).text(QAccessible::Name), u"Zeta"_s);
    }

    /** Every widget with keyboard focus has a name, if only that of its container. */
    void nothingFocusableIsNameless()
    {
        QWidget window;
        window.setWindowTitle(u"Shortcuts[*]"_s);
        auto* scroll = new QScrollArea(&window);
        scroll->setFocusPolicy(Qt::StrongFocus);
        QCOMPARE(interfaceOf(*scroll).text(QAccessible::Name), u"Shortcuts"_s);
        scroll->setAccessibleName(u"Keys"_s);
        QCOMPARE(interfaceOf(*scroll).text(QAccessible::Name), u"Keys"_s);
        scroll->viewport()->setFocusPolicy(Qt::StrongFocus);
        QCOMPARE(interfaceOf(*scroll->viewport()).text(QAccessible::Name), u"Keys"_s);
    }

    void comboBoxesReportTheirLabels()
    {
        QComboBox combo;
        combo.addItems({u"one"_s, u"two"_s});
        QAccessibleInterface& list = interfaceOf(combo);
        QCOMPARE(list.role(), QAccessible::ComboBox);
        QCOMPARE(list.text(QAccessible::Name), u"one"_s);
        combo.setAccessibleName(u"Policy"_s);
        QCOMPARE(list.text(QAccessible::Name), u"Policy: one"_s);
        QCOMPARE(list.childCount(), 1);
        QCOMPARE(list.child(0)->role(), QAccessible::List);
        QCOMPARE(list.indexOfChild(list.child(0)), 0);
        QVERIFY(list.child(1) == nullptr);
        combo.setEditable(true);
        QCOMPARE(list.child(1)->role(), QAccessible::EditableText);
        QVERIFY(list.state().editable);
    }

    /** Choosing by action emits the same signals as choosing by the user. */
    void listsAreChosenFrom()
    {
        QComboBox combo;
        combo.addItems({u"one"_s, u"two"_s});
        combo.setAccessibleName(u"Policy"_s);
        QSignalSpy activated(&combo, &QComboBox::activated);
        QAccessibleActionInterface& actions = *interfaceOf(combo).actionInterface();
        actions.doAction(QAccessibleActionInterface::increaseAction());
        QTRY_COMPARE(combo.currentIndex(), 1);
        QCOMPARE(activated.count(), 1);
        QCOMPARE(interfaceOf(combo).text(QAccessible::Value), u"two"_s);
        actions.doAction(QAccessibleActionInterface::decreaseAction());
        QTRY_COMPARE(combo.currentIndex(), 0);
        combo.setEnabled(false);
        QVERIFY(!actions.actionNames().contains(QAccessibleActionInterface::increaseAction()));
    }

    /** By the action that screen readers have for a row. */
    void whatIsSelectedIsCurrent()
    {
        QListWidget list;
        list.addItems({u"one"_s, u"two"_s, u"three"_s});
        followSelection(list);
        list.setCurrentRow(0);
        QSignalSpy current(&list, &QListWidget::currentRowChanged);
        QAccessibleInterface* row = interfaceOf(list).child(2);
        row->actionInterface()->doAction(QAccessibleActionInterface::toggleAction());
        QTRY_COMPARE(list.currentRow(), 2);
        QCOMPARE(current.count(), 1);
        QCOMPARE(list.selectedItems().size(), 1);
        list.setCurrentRow(1); // as keys do
        QCOMPARE(list.currentRow(), 1);
        QCoreApplication::processEvents();
        QCOMPARE(current.count(), 2);
    }

    /** Heads of groups are neither current nor enabled. */
    void aHeadIsNotCurrent()
    {
        QListWidget list;
        list.addItems({u"head"_s, u"one"_s});
        list.item(0)->setFlags(Qt::NoItemFlags);
        followSelection(list);
        list.setCurrentRow(1);
        list.selectionModel()->select(list.model()->index(0, 0),
                                      QItemSelectionModel::ClearAndSelect);
        QCoreApplication::processEvents();
        QCOMPARE(list.currentRow(), 1);
    }

    /** The menu of a widget of ours is reached without pointer and keys. */
    void menuIsAnAction()
    {
        QWidget window;
        Painted chart(&window);
        const QString menu = QAccessibleActionInterface::showMenuAction();
        QVERIFY(!interfaceOf(chart).actionInterface()->actionNames().contains(menu));
        setAccessibleRole(chart, QAccessible::Chart);
        QVERIFY(interfaceOf(chart).actionInterface()->actionNames().contains(menu));
        interfaceOf(chart).actionInterface()->doAction(menu);
        QTRY_COMPARE(chart.menus, 1);
        QAction values(u"Show values"_s, &chart);
        chart.addAction(&values);
        QSignalSpy shown(&values, &QAction::triggered);
        interfaceOf(chart).actionInterface()->doAction(u"Show values"_s);
        QTRY_COMPARE(shown.count(), 1);
        QCOMPARE(chart.menus, 1);
        values.setEnabled(false);
        QVERIFY(!interfaceOf(chart).actionInterface()->actionNames().contains(u"Show values"_s));
        chart.setEnabled(false);
        QVERIFY(!interfaceOf(chart).actionInterface()->actionNames().contains(menu));
    }
};

QTEST_MAIN(TestAccessibleRoles)
#include "tst_accessible_roles.moc"
