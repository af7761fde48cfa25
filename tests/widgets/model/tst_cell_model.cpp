#include "widgets/model/cell_model.h"

#include <QSignalSpy>
#include <QtTest>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/** Returns names and numbers, sorted by the numbers. */
CellSheet sheetOf(const QStringList& names, const std::vector<double>& numbers)
{
    return {.titles = {u"Name"_s, u"Number"_s},
            .rows = static_cast<int>(names.size()),
            .text =
                [names, numbers](int row, int column) {
                    return column == 0 ? names[row]
                                       : QString::number(numbers[static_cast<std::size_t>(row)]);
                },
            .key =
                [names, numbers](int row, int column) {
                    return column == 0 ? CellKey{.text = names[row]}
                                       : CellKey{.number = numbers[static_cast<std::size_t>(row)]};
                },
            .hasNumbers = true};
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
