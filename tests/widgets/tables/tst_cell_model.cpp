#include "widgets/tables/cell_model.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QtTest>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/** Returns names and numbers, sorted by the numbers. */
CellSheet sheetOf(const QStringList& names, const std::vector<double>& numbers)
{
    const auto number = [numbers](int row) { return numbers[static_cast<std::size_t>(row)]; };
    return {.columns =
                withNumbers({{.title = u"Name"_s, .text = [names](int row) { return names[row]; }},
                             {.title = u"Number"_s,
                              .text = [number](int row) { return QString::number(number(row)); },
                              .key = number}}),
            .rows = static_cast<int>(names.size())};
}

QStringList column(const CellModel& model, int column)
{
    QStringList texts;
    for (int row = 0; row < model.rowCount(); ++row)
        texts << model.index(row, column).data().toString();
    return texts;
}

} // namespace

class TestCellModel : public QObject
{
    Q_OBJECT

private slots:
    void rowsAreSortedByNumbers()
    {
        CellModel model;
        model.setSheet(sheetOf({u"b"_s, u"c"_s, u"a"_s}, {100, 9, 20}));
        model.sort(1, Qt::AscendingOrder);
        QCOMPARE(column(model, 1), (QStringList{u"9"_s, u"20"_s, u"100"_s}));
        model.sort(0, Qt::DescendingOrder);
        QCOMPARE(column(model, 0), (QStringList{u"c"_s, u"b"_s, u"a"_s}));
        model.sort(-1, Qt::AscendingOrder);
        QCOMPARE(column(model, 0), (QStringList{u"b"_s, u"c"_s, u"a"_s}));
    }

    void equalRowsStayInTheirOrder()
    {
        CellModel model;
        model.setSheet(sheetOf({u"b"_s, u"a"_s, u"c"_s}, {1, 1, 1}));
        for (const Qt::SortOrder order : {Qt::AscendingOrder, Qt::DescendingOrder}) {
            model.sort(1, order);
            QCOMPARE(column(model, 0), (QStringList{u"b"_s, u"a"_s, u"c"_s}));
        }
    }

    void indexFollowsItsRow()
    {
        CellModel model;
        model.setSheet(sheetOf({u"b"_s, u"c"_s, u"a"_s}, {3, 2, 1}));
        const QPersistentModelIndex chosen = model.index(0, 0);
        model.sort(1, Qt::AscendingOrder);
        QCOMPARE(chosen.row(), 2);
        QCOMPARE(chosen.data().toString(), u"b"_s);
        QCOMPARE(model.sourceRow(2), 0);
        QCOMPARE(model.shownRow(0).value(), 2);
        QVERIFY(!model.shownRow(7));
    }

    void newNumbersInTheSameOrderResetNothing()
    {
        CellModel model;
        model.setSheet(sheetOf({u"a"_s, u"b"_s}, {1, 2}));
        model.sort(1, Qt::AscendingOrder);
        QSignalSpy resets(&model, &CellModel::modelReset);
        QSignalSpy changes(&model, &CellModel::dataChanged);
        model.setSheet(sheetOf({u"a"_s, u"b"_s}, {3, 4}));
        QCOMPARE(resets.count(), 0);
        QCOMPARE(changes.count(), 1);
        model.setSheet(sheetOf({u"a"_s, u"b"_s}, {6, 5}));
        QCOMPARE(resets.count(), 1);
        QCOMPARE(column(model, 0), (QStringList{u"b"_s, u"a"_s}));
    }

    void cellsWithoutANumberComeLast()
    {
        CellModel model;
        CellSheet sheet = sheetOf({u"a"_s, u"b"_s, u"c"_s}, {1, 2, 3});
        sheet.columns[1].key = [](int row) {
            return row == 1 ? CellKey(std::nullopt) : CellKey(double(row));
        };
        model.setSheet(sheet);
        model.sort(1, Qt::AscendingOrder);
        QCOMPARE(column(model, 0), (QStringList{u"a"_s, u"c"_s, u"b"_s}));
        model.sort(1, Qt::DescendingOrder);
        QCOMPARE(column(model, 0), (QStringList{u"c"_s, u"a"_s, u"b"_s}));
    }

    void onlyTheSpanOfOtherTextsIsReported()
    {
        CellModel model;
        const QAbstractItemModelTester tester(&model);
        const QStringList names{u"a"_s, u"b"_s, u"c"_s, u"d"_s};
        model.setSheet(sheetOf(names, {1, 2, 3, 4}));
        QSignalSpy changes(&model, &CellModel::dataChanged);
        model.updateSheet(sheetOf(names, {1, 2, 3, 4}));
        QCOMPARE(changes.count(), 0);
        model.updateSheet(sheetOf(names, {1, 5, 6, 4}));
        QCOMPARE(changes.count(), 1);
        QCOMPARE(changes.front().at(0).toModelIndex(), model.index(1, 0));
        QCOMPARE(changes.front().at(1).toModelIndex(), model.index(2, 1));
        model.updateSheet(sheetOf(names, {1, 5, 6, 7}), [](int row) { return row != 0; });
        QCOMPARE(changes.count(), 2);
        QCOMPARE(changes.back().at(1).toModelIndex(), model.index(0, 1));
    }

    void rowsAreAddedAndRemovedAtTheEnd()
    {
        CellModel model;
        const QAbstractItemModelTester tester(&model);
        model.setSheet(sheetOf({u"a"_s, u"b"_s}, {1, 2}));
        const QPersistentModelIndex chosen = model.index(1, 0);
        QSignalSpy resets(&model, &CellModel::modelReset);
        model.updateSheet(sheetOf({u"a"_s, u"b"_s, u"c"_s}, {1, 2, 3}));
        QCOMPARE(column(model, 0), (QStringList{u"a"_s, u"b"_s, u"c"_s}));
        QVERIFY(chosen.isValid());
        model.updateSheet(sheetOf({u"a"_s}, {1}));
        QCOMPARE(column(model, 0), QStringList{u"a"_s});
        QVERIFY(!chosen.isValid());
        QCOMPARE(resets.count(), 0);
    }

    void updatedRowsKeepTheirIndices()
    {
        CellModel model;
        const QAbstractItemModelTester tester(&model);
        const QStringList names{u"a"_s, u"b"_s, u"c"_s};
        model.setSheet(sheetOf(names, {1, 2, 3}));
        model.sort(1, Qt::AscendingOrder);
        const QPersistentModelIndex chosen = model.index(0, 0);
        QSignalSpy resets(&model, &CellModel::modelReset);
        model.updateSheet(sheetOf(names, {4, 2, 3}));
        QCOMPARE(column(model, 0), (QStringList{u"b"_s, u"c"_s, u"a"_s}));
        QCOMPARE(chosen.row(), 2);
        CellSheet filtered = sheetOf(names, {4, 2, 3});
        filtered.isShown = [](int row) { return row != 1; };
        model.updateSheet(filtered);
        QCOMPARE(column(model, 0), (QStringList{u"c"_s, u"a"_s}));
        QCOMPARE(resets.count(), 1);
        filtered.isShown = [](int row) { return row != 0; };
        model.updateSheet(filtered);
        QCOMPARE(column(model, 0), (QStringList{u"b"_s, u"c"_s}));
        QCOMPARE(resets.count(), 1);
    }

    void cellIsEditedInItsRowOfTheSheet()
    {
        CellModel model;
        CellSheet sheet = sheetOf({u"b"_s, u"a"_s}, {1, 2});
        int edited = -1;
        sheet.columns[0].edit = [&edited](int row, const QVariant& value) {
            edited = row;
            return value.toString() == u"c"_s;
        };
        model.setSheet(sheet);
        model.sort(0, Qt::AscendingOrder);
        QVERIFY(!model.flags(model.index(0, 1)).testFlag(Qt::ItemIsEditable));
        QVERIFY(!model.setData(model.index(0, 1), u"c"_s, Qt::EditRole));
        QVERIFY(model.flags(model.index(0, 0)).testFlag(Qt::ItemIsEditable));
        QCOMPARE(model.index(0, 0).data(Qt::EditRole).toString(), u"a"_s);
        QVERIFY(model.setData(model.index(0, 0), u"c"_s, Qt::EditRole));
        QCOMPARE(edited, 1);
    }

    void numbersStandOnTheRight()
    {
        CellModel model;
        model.setSheet(sheetOf({u"a"_s}, {1}));
        QCOMPARE(model.index(0, 0).data(Qt::TextAlignmentRole).toInt(),
                 int(Qt::AlignLeft | Qt::AlignVCenter));
        QCOMPARE(model.headerData(1, Qt::Horizontal, Qt::TextAlignmentRole).toInt(),
                 int(Qt::AlignRight | Qt::AlignVCenter));
    }
};

QTEST_MAIN(TestCellModel)
#include "tst_cell_model.moc"
