#include "app/settings/system_appearance.h"
#include "widgets/theme/palette.h"

#include <QSignalSpy>
#include <QtTest>

using namespace berg;

class TestSystemAppearance : public QObject
{
    Q_OBJECT

private slots:
    void thePortalDecides()
    {
        SystemAppearance system;
        QSignalSpy changed(&system, &SystemAppearance::changed);
        const bool palette = systemPaletteIsDark();
        QCOMPARE(system.isDark(), palette);
        system.setColourScheme(palette ? 2 : 1);
        QCOMPARE(system.isDark(), !palette);
        QCOMPARE(changed.count(), 1);
        system.setColourScheme(palette ? 2 : 1); // said again
        QCOMPARE(changed.count(), 1);
        system.setColourScheme(palette ? 1 : 2);
        QCOMPARE(system.isDark(), palette);
        QCOMPARE(changed.count(), 2);
    }

    void contrastIsFollowed()
    {
        SystemAppearance system;
        QSignalSpy changed(&system, &SystemAppearance::changed);
        QVERIFY(!system.wantsContrast());
        for (const uint contrast : {0U, 2U, 99U}) // the portal knows 1 alone
            system.setContrast(contrast);
        QCOMPARE(changed.count(), 0);
        system.setContrast(1);
        QVERIFY(system.wantsContrast());
        system.setContrast(1);
        QCOMPARE(changed.count(), 1);
        system.setContrast(0);
        QVERIFY(!system.wantsContrast());
        QCOMPARE(changed.count(), 2);
    }

    void withoutPreferenceThePaletteDecides()
    {
        SystemAppearance system;
        for (const uint scheme : {0U, 3U, 99U}) {
            system.setColourScheme(scheme);
            QCOMPARE(system.isDark(), systemPaletteIsDark());
        }
    }

    /** The program's own appearance is not mistaken for the desktop's. */
    void ownPaletteIsNotTheSystems()
    {
        const bool before = systemPaletteIsDark();
        for (const Theme& theme : {Theme::dark(), Theme::light()}) {
            QApplication::setPalette(paletteOf(theme));
            QCOMPARE(systemPaletteIsDark(), before);
            QCOMPARE(QApplication::palette().color(QPalette::Window),
                     paletteOf(theme).color(QPalette::Window)); // and stays
        }
        QApplication::setPalette(QPalette());
    }
};

QTEST_MAIN(TestSystemAppearance)
#include "tst_system_appearance.moc"
