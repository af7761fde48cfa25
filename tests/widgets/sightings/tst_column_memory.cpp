#include "widgets/sightings/column_memory.h"

#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

using namespace berg;
using namespace Qt::StringLiterals;

class TestColumnMemory : public QObject
{
    Q_OBJECT

private slots:
    void mappingIsStoredByTheHeader()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"settings.ini"_s);
        const QStringList header{u"who"_s, u"up, or down"_s, u"right=east"_s};
        const ColumnMapping mapping{{SightingField::Latitude, "up, or down"},
                                    {SightingField::Longitude, "right=east"}};
        {
            QSettings settings(path, QSettings::IniFormat);
            QVERIFY(columnsFor(settings, header).empty());
            rememberColumns(settings, header, mapping);
        }
        QSettings settings(path, QSettings::IniFormat);
        QVERIFY(columnsFor(settings, header) == mapping);
        QVERIFY(columnsFor(settings, {u" WHO"_s, u"Up,  or down"_s, u"right=east "_s}) == mapping);
        QVERIFY(columnsFor(settings, {u"up, or down"_s, u"who"_s, u"right=east"_s}).empty());
        QVERIFY(columnsFor(settings, header.mid(1)).empty());
        const ColumnMapping other{{SightingField::Id, "who"}};
        rememberColumns(settings, header, other);
        QVERIFY(columnsFor(settings, header) == other);
        QCOMPARE(rememberedColumns(settings).size(), std::size_t{1});
        forgetColumns(settings, headerFingerprint(header));
        QVERIFY(rememberedColumns(settings).empty());
    }

    void theLatestFiftyAreKept()
    {
        const QTemporaryDir folder;
        QSettings settings(folder.filePath(u"settings.ini"_s), QSettings::IniFormat);
        const auto header = [](int i) { return QStringList{u"lat"_s, QString::number(i)}; };
        for (int i = 0; i < 60; ++i)
            rememberColumns(settings, header(i), {{SightingField::Latitude, "lat"}});
        const std::vector<RememberedColumns> all = rememberedColumns(settings);
        QCOMPARE(all.size(), std::size_t{50});
        QCOMPARE(all.front().header, header(59));
        QCOMPARE(all.back().header, header(10));
    }

    /** Settings changed by an editor are not read as columns. */
    void brokenEntriesAreLeftOut()
    {
        const QTemporaryDir folder;
        QSettings settings(folder.filePath(u"settings.ini"_s), QSettings::IniFormat);
        rememberColumns(settings, {u"a"_s}, {{SightingField::Latitude, "a"}});
        settings.setValue(u"import/columns/1/fields"_s,
                          QStringList{u"nothing=a"_s, u"latitude="_s, u"latitude"_s});
        QVERIFY(rememberedColumns(settings).empty());
        settings.setValue(u"import/columns/size"_s, 1'000'000'000);
        QVERIFY(rememberedColumns(settings).empty());
    }
};

QTEST_GUILESS_MAIN(TestColumnMemory)
#include "tst_column_memory.moc"
