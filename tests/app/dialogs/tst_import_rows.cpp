#include "tests/support/window/import_dialog_test.h"
#include "widgets/sightings/column_memory.h"

#include <QMenu>
#include <QSettings>
#include <QSpinBox>
#include <QTabWidget>
#include <QTemporaryDir>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

/** A dialog with settings that remember. */
class Remembering
{
public:
    Remembering(const QString& path, QSettings& settings)
        : m_dialog(m_runner,
                   {.path = path,
                    .present = std::make_shared<const Scenario>(openSea()),
                    .theme = Theme::light()},
                   nullptr, &settings)
    {
        m_dialog.show();
    }

    [[nodiscard]] ImportDialog& dialog() { return m_dialog; }
    [[nodiscard]] bool settles()
    {
        return QTest::qWaitFor([this] { return !m_runner.isBusy(); }, 60000);
    }
    [[nodiscard]] QComboBox& column(const char* field)
    {
        return child<QComboBox>(m_dialog, u"column-"_s + QString::fromLatin1(field));
    }
    void choose(const char* field, const QString& name)
    {
        QComboBox& box = column(field);
        const int row = box.findData(name);
        box.setCurrentIndex(row);
        emit box.activated(row);
    }

private:
    ImportRunner m_runner;
    ImportDialog m_dialog;
};

QStringList visibleTabs(QTabWidget& tabs)
{
    QStringList names;
    for (int i = 0; i < tabs.count(); ++i)
        if (tabs.isTabVisible(i))
            names << tabs.tabText(i);
    return names;
}

} // namespace

class TestImportRows : public QObject
{
    Q_OBJECT

private slots:
    void init() { failOnWarnings(); }

    /** Rows that are taken in part, and sightings outside, are listed as rejected ones are. */
    void changedAndOutsideRowsAreListed()
    {
        const QTemporaryDir folder;
        const QString path = written(folder.filePath(u"rows.csv"_s),
                                     "id;lat;lon;speed\na;47;-48;fast\nb;47.1;-48;0.9 km/h\n"
                                     "c;70;-48;\nd;91;-48;\n");
        Importing import(path);
        QVERIFY(import.settles());
        auto& tabs = import.at<QTabWidget>(u"importTabs"_s);
        QCOMPARE(visibleTabs(tabs), (QStringList{u"Icebergs (2)"_s, u"Rejected rows (2)"_s,
                                                 u"Changed rows (1)"_s, u"Columns"_s}));
        QCOMPARE(import.cell(u"importNoted"_s, 0, 0), u"2"_s);
        QCOMPARE(import.cell(u"importNoted"_s, 0, 1),
                 u"taken without a value that cannot be read"_s);
        QCOMPARE(import.cell(u"importNoted"_s, 0, 2), u"speed: fast"_s);
        QVERIFY(import.summary().contains(u"1 row changed"_s));
        QVERIFY(import.at<QLabel>(u"importScene"_s)
                    .text()
                    .startsWith(u"1 sighting is more than 1000 km from the origin"_s));
        import.check(u"importAreaBox"_s);
        enter(import.at<QWidget>(u"importEdge2"_s), u"50"_s);
        QVERIFY(import.settles());
        QCOMPARE(visibleTabs(tabs),
                 (QStringList{u"Icebergs (2)"_s, u"Rejected rows (1)"_s, u"Changed rows (1)"_s,
                              u"Outside area or time (1)"_s, u"Columns"_s}));
        QCOMPARE(import.cell(u"importOutside"_s, 0, 0), u"4"_s);
        QCOMPARE(import.cell(u"importOutside"_s, 0, 1), u"lies outside the chosen area"_s);
    }

    void headerLineIsChosen()
    {
        const QTemporaryDir folder;
        const QString path = written(folder.filePath(u"title.csv"_s),
                                     "Ice report\nid;lat;lon\na;47;-48\nid;lat;lon\nb;48;-48\n");
        Importing import(path);
        QVERIFY(import.settles());
        auto& line = import.at<QSpinBox>(u"importHeaderLine"_s);
        QCOMPARE(line.text(), u"Automatic: 2"_s);
        QCOMPARE(import.rows(u"importHead"_s).headerData(0, Qt::Horizontal).toString(),
                 u"id\nId"_s);
        line.setValue(4);
        QVERIFY(import.settles());
        QCOMPARE(import.dialog().choice()->scenario.icebergs.size(), 1U);
        QCOMPARE(import.dialog().choice()->scenario.icebergs[0].id, std::string("b"));
        QCOMPARE(import.rows(u"importHead"_s).rowCount(), 1);
    }

    void columnsAreRemembered()
    {
        const QTemporaryDir folder;
        QSettings settings(folder.filePath(u"settings.ini"_s), QSettings::IniFormat);
        const QString first = written(folder.filePath(u"one.csv"_s), "who,up,right\na,60,-50\n");
        {
            Remembering import(first, settings);
            QVERIFY(import.settles());
            QVERIFY(!import.dialog().choice());
            import.choose("latitude", u"up"_s);
            import.choose("longitude", u"right"_s);
            import.choose("id", u"who"_s);
            QVERIFY(import.settles());
            QVERIFY(import.dialog().choice().has_value());
            QVERIFY(rememberedColumns(settings).empty()); // nothing was imported yet
            import.dialog().accept();
            QCOMPARE(rememberedColumns(settings).size(), std::size_t{1});
        }
        const QString next = written(folder.filePath(u"two.csv"_s), "who,up,right\nb,61,-51\n");
        {
            Remembering import(next, settings);
            QVERIFY(import.settles());
            QCOMPARE(import.dialog().choice()->scenario.icebergs.at(0).id, std::string("b"));
            auto& inUse = child<QLabel>(import.dialog(), u"importColumnsInUse"_s);
            QVERIFY(!inUse.isHidden());
            QCOMPARE(inUse.text(), u"Columns as for the last file with this header."_s);
            QMenu& menu = *child<QPushButton>(import.dialog(), u"importForget"_s).menu();
            QCOMPARE(menu.actions().front()->text(), u"who, up, right"_s);
            menu.actions().front()->trigger();
            QVERIFY(import.settles());
            QVERIFY(rememberedColumns(settings).empty());
            QVERIFY(inUse.isHidden());
            QVERIFY(!import.dialog().choice());
            QCOMPARE(import.column("latitude").currentIndex(), 0);
        }
        const QString other = written(folder.filePath(u"three.csv"_s), "who,up,east\nb,61,-51\n");
        rememberColumns(settings, {u"who"_s, u"up"_s, u"right"_s},
                        {{SightingField::Latitude, "up"}});
        Remembering import(other, settings);
        QVERIFY(import.settles());
        QCOMPARE(import.column("latitude").currentIndex(), 0); // of another header
    }
};

QTEST_MAIN(TestImportRows)
#include "tst_import_rows.moc"
