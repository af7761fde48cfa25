#include "app/dialogs/export_dialog.h"
#include "app/dialogs/generate_dialog.h"
#include "app/dialogs/import_dialog.h"
#include "app/dialogs/origin_dialog.h"
#include "app/dialogs/recovery_dialog.h"
#include "app/dialogs/wind_dialog.h"
#include "app/start/start_page.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/manual/manual_places.h"
#include "widgets/manual/manual_window.h"

#include <QDockWidget>
#include <QTextBrowser>
#include <QTreeWidget>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

/** The manual below `parent`, opened by F1 in what has the focus. */
ManualWindow* openedIn(QWidget& parent, QWidget& focus)
{
    focus.setFocus();
    QTest::keyClick(&focus, Qt::Key_F1);
    return parent.findChild<ManualWindow*>(QString(), Qt::FindDirectChildrenOnly);
}

/** Names of all objects in the widget and of their classes. */
QStringList namesIn(const QWidget& widget)
{
    QStringList names{widget.objectName(), QLatin1String(widget.metaObject()->className())};
    for (const QObject* inner : widget.findChildren<QObject*>())
        names << inner->objectName() << QLatin1String(inner->metaObject()->className());
    return names;
}

} // namespace

/** F1 in the real window: in each panel, in dialogs, and in the menu. */
class TestManualHelp : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    /** Whatever panel is added has a place in the manual. */
    void everyDockHasAPlace()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const QList<QDockWidget*> docks = w.window().findChildren<QDockWidget*>();
        QCOMPARE(docks.size(), 18);
        for (const QDockWidget* dock : docks) {
            const QString place = manualPlaceOf(dock->widget());
            QVERIFY2(place.startsWith(u"window#"_s), qPrintable(dock->objectName()));
        }
        for (const char* panel : {"alarmStrip", "mapView", "findBox"})
            QVERIFY2(manualPlaceOf(&test::child<QWidget>(w.window(), QLatin1String(panel)))
                         .startsWith(u"window#"_s),
                     panel);
        QCOMPARE(manualPlaceOf(&test::child<QWidget>(w.window(), u"timeField"_s)),
                 u"window#playback"_s);
    }

    /** A widget that goes or is renamed takes its place in the manual along. */
    void everyPlaceIsOfAWidget()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.trigger(u"tourAction"_s);
        QStringList names =
            namesIn(w.window()) + namesIn(StartPage(QString(), true, true, &w.window())) +
            namesIn(GenerateDialog(w.scenario(), w.map().view().visible(w.map().rect())));
        for (const QMetaObject* dialog :
             {&ExportDialog::staticMetaObject, &ImportDialog::staticMetaObject,
              &OriginDialog::staticMetaObject, &RecoveryDialog::staticMetaObject,
              &WindDialog::staticMetaObject})
            names << QLatin1String(dialog->className());
        for (const ManualPlace& known : kManualPlaces)
            QVERIFY2(names.contains(QLatin1String(known.widget)), known.widget);
    }

    void f1OpensThePlaceOfTheFocus()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        ManualWindow* manual = openedIn(w.window(), w.map());
        QVERIFY(manual != nullptr && manual->isVisible());
        QCOMPARE(manual->place(), u"window#map"_s);
        w.window().activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&w.window()));
        auto& tau = test::child<QWidget>(w.window(), u"tauField"_s);
        QCOMPARE(openedIn(w.window(), tau), manual);
        QCOMPARE(manual->place(), u"window#trade-off"_s);
    }

    void theMenuOpensItToo()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QCOMPARE(w.action(u"manualAction"_s).shortcut(), QKeySequence(Qt::Key_F1));
        w.map().setFocus();
        w.trigger(u"manualAction"_s);
        QCOMPARE(w.window().findChildren<ManualWindow*>().size(), 1);
    }

    /** A modal dialog lets only its own children be used. */
    void dialogsHaveItAsWell()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        WindDialog dialog(Point(3, 0), 22, &w.window());
        dialog.setModal(true);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowActive(&dialog));
        ManualWindow* manual = openedIn(dialog, test::child<QWidget>(dialog, u"windSpeed"_s));
        QVERIFY(manual != nullptr);
        QCOMPARE(manual->place(), u"window#wind"_s);
        test::child<QTreeWidget>(*manual, u"manualList"_s).setFocus();
    }
};

QTEST_MAIN(TestManualHelp)
#include "tst_manual_help.moc"
