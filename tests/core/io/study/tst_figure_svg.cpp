#include "core/io/figure/figure_svg.h"

#include <QtTest>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

std::string noText(double, int)
{
    return {};
}

} // namespace

class TestFigureSvg : public QObject
{
    Q_OBJECT

private slots:
    /** Policies differ by shape as well as by colour, also in the file. */
    void marksHaveTheirShapes()
    {
        Figure figure;
        figure.x = {.largest = 9, .text = noText};
        figure.y = {.largest = 2, .text = noText};
        double x = 0;
        for (const MarkShape shape :
             {MarkShape::Disk, MarkShape::Diamond, MarkShape::Square, MarkShape::Triangle,
              MarkShape::TriangleDown, MarkShape::Hexagon, MarkShape::Star, MarkShape::Ring})
            figure.marks.push_back({.at = {x += 1, 1}, .shape = shape});
        const QString svg = QString::fromStdString(figureSvg(figure, 600, 400));
        QCOMPARE(svg.count("<circle"_L1), 2);
        QList<qsizetype> corners;
        for (const QString& polygon : svg.split("<polygon"_L1).mid(1)) {
            const qsizetype begin = polygon.indexOf("points=\""_L1) + 8;
            corners.append(polygon.mid(begin, polygon.indexOf(u'"', begin) - begin).count(u','));
        }
        QCOMPARE(corners, QList<qsizetype>({4, 4, 3, 3, 6, 10}));
    }
};

QTEST_GUILESS_MAIN(TestFigureSvg)
#include "tst_figure_svg.moc"
