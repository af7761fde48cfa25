#include "core/base/random.h"
#include "core/io/files/tsplib.h"
#include "core/plan/solve/latency_problem.h"

#include <QTest>

#include <cmath>
#include <functional>
#include <numeric>

using namespace berg;

namespace {

using Matrix = std::vector<std::vector<int>>;

ProblemFile read(const std::string& text)
{
    return problemFromTsplib(text, "file");
}

/** Returns whole weights from 1 to 99. */
Matrix randomMatrix(std::uint64_t seed, std::size_t nodes, bool isSymmetric)
{
    Random random(seed, 5);
    Matrix matrix(nodes, std::vector<int>(nodes, 0));
    for (std::size_t i = 0; i < nodes; ++i)
        for (std::size_t j = 0; j < nodes; ++j)
            if (i != j)
                matrix[i][j] =
                    isSymmetric && j < i ? matrix[j][i] : 1 + static_cast<int>(random.below(99));
    return matrix;
}

/** Returns the entries of a matrix form as the format describes it, cell by cell. */
std::vector<int> entriesOf(const Matrix& m, const std::string& form)
{
    const bool byColumn = form.ends_with("COL");
    const bool isFull = form.starts_with("FULL");
    const bool isUpper = form.starts_with("UPPER");
    const bool hasDiagonal = isFull || form.find("DIAG") != std::string::npos;
    std::vector<int> entries;
    for (std::size_t outer = 0; outer < m.size(); ++outer)
        for (std::size_t inner = 0; inner < m.size(); ++inner) {
            const std::size_t row = byColumn ? inner : outer;
            const std::size_t column = byColumn ? outer : inner;
            const bool isThere = isFull || (isUpper ? row < column : row > column);
            if (isThere || (hasDiagonal && row == column))
                entries.push_back(m[row][column]);
        }
    return entries;
}

/** Returns an explicit instance with `perLine` numbers on each line. */
std::string explicitText(const Matrix& m, const std::string& form, std::size_t perLine)
{
    std::string text = "NAME: made\nTYPE: TSP\nDIMENSION: " + std::to_string(m.size()) +
                       "\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: " + form +
                       "\nEDGE_WEIGHT_SECTION\n";
    std::size_t count = 0;
    for (const int entry : entriesOf(m, form))
        text += ' ' + std::to_string(entry) + (++count % perLine == 0 ? "\n" : "");
    return text + "\nEOF\n";
}

/**
 * Returns the least sum of arrival times over all orders, optionally including the return to the
 * start.
 */
double leastLatency(const Eigen::MatrixXd& d, bool countsReturn)
{
    std::vector<Eigen::Index> order(static_cast<std::size_t>(d.rows() - 1));
    std::iota(order.begin(), order.end(), 1);
    double least = std::numeric_limits<double>::infinity();
    do {
        double now = 0;
        double sum = 0;
        Eigen::Index from = 0;
        for (const Eigen::Index to : order) {
            now += d(from, to);
            sum += now;
            from = to;
        }
        if (countsReturn)
            sum += now + d(from, 0);
        least = std::min(least, sum);
    } while (std::next_permutation(order.begin(), order.end()));
    return least;
}

/** Returns the length of the shortest round tour. */
double leastTour(const Eigen::MatrixXd& d)
{
    std::vector<Eigen::Index> tour(static_cast<std::size_t>(d.rows()));
    std::iota(tour.begin(), tour.end(), 0);
    double least = std::numeric_limits<double>::infinity();
    do {
        double length = d(tour.back(), tour.front());
        for (std::size_t k = 1; k < tour.size(); ++k)
            length += d(tour[k - 1], tour[k]);
        least = std::min(least, length);
    } while (std::next_permutation(tour.begin() + 1, tour.end()));
    return least;
}

/** Checks the optima of the shortest tour, of latency, and of latency with the return. */
void checkOptima(const TvpProblem& problem)
{
    const auto solver = makeSolver(Backend::Exact);
    const TvpProblem latency = latencyProblem(problem);
    // All objectives are sums of a few whole numbers.
    QCOMPARE(solver->solve(problem, {}).objective, leastTour(problem.distance_m));
    QCOMPARE(solver->solve(latency, {}).objective, leastLatency(problem.distance_m, false));
    QCOMPARE(solver->solve(withReturn(latency), {}).objective,
             leastLatency(problem.distance_m, true));
}

void checkMatrix(const Eigen::MatrixXd& d, const Matrix& expected)
{
    QCOMPARE(d.rows(), static_cast<Eigen::Index>(expected.size()));
    for (std::size_t i = 0; i < expected.size(); ++i)
        for (std::size_t j = 0; j < expected.size(); ++j)
            if (i != j)
                QCOMPARE(d(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)),
                         expected[i][j]);
}

std::string placesText(const std::string& type, const std::string& rows, int nodes)
{
    return "TYPE : TSP\nDIMENSION : " + std::to_string(nodes) + "\nEDGE_WEIGHT_TYPE : " + type +
           "\nNODE_COORD_SECTION\n" + rows + "EOF\n";
}

/** Converts degrees and minutes to radians with TSPLIB's pi, through their text. */
double radians(int degrees, int minutes)
{
    const double size = std::abs(degrees) + minutes / 60.0;
    return (degrees < 0 ? -size : size) * 3.141592 / 180;
}

/** Great-circle distance by haversines, a formula independent of the format's. */
double haversine_km(double lat1, double lon1, double lat2, double lon2)
{
    const double a = std::pow(std::sin((lat2 - lat1) / 2), 2) +
                     std::cos(lat1) * std::cos(lat2) * std::pow(std::sin((lon2 - lon1) / 2), 2);
    return 2 * 6378.388 * std::asin(std::sqrt(a));
}

} // namespace

/** Tests of the weights of TSPLIB instances and of their solutions. */
class TestTsplibWeights : public QObject
{
    Q_OBJECT

private slots:
    void matrixFormsAreFilledCellByCell_data()
    {
        QTest::addColumn<bool>("isSymmetric");
        for (const char* form :
             {"FULL_MATRIX", "UPPER_ROW", "LOWER_ROW", "UPPER_DIAG_ROW", "LOWER_DIAG_ROW",
              "UPPER_COL", "LOWER_COL", "UPPER_DIAG_COL", "LOWER_DIAG_COL"})
            QTest::newRow(form) << true;
        QTest::newRow("FULL_MATRIX ") << false;
    }
    void matrixFormsAreFilledCellByCell()
    {
        QFETCH(const bool, isSymmetric);
        const std::string form = QByteArray(QTest::currentDataTag()).trimmed().toStdString();
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            const Matrix matrix = randomMatrix(seed, 2 + seed % 6, isSymmetric);
            // Lines may end anywhere in the matrix.
            const ProblemFile file = read(explicitText(matrix, form, 1 + seed));
            QVERIFY(file.isTsplib && file.hints.empty());
            checkMatrix(file.problem.distance_m, matrix);
            checkOptima(file.problem);
        }
    }

    void planeDistancesAreRoundedByType_data()
    {
        QTest::addColumn<QByteArray>("type");
        QTest::addColumn<QByteArray>("place"); // the other place is 0 0
        QTest::addColumn<double>("distance");
        const auto row = [](const char* type, const char* place, double distance) {
            QTest::addRow("%s: %s", type, place)
                << QByteArray(type) << QByteArray(place) << distance;
        };
        row("EUC_2D", "3 4", 5);
        row("EUC_2D", "1 1", 1);    // 1.41
        row("EUC_2D", "-1.5 0", 2); // half a unit is rounded up
        row("EUC_2D", "2.49 0", 2);
        row("EUC_2D", "+1.5e1 2E+1", 25);
        row("CEIL_2D", "3 4", 5);
        row("CEIL_2D", "1 1", 2);
        row("CEIL_2D", "0 -2.01", 3);
        row("ATT", "10 30", 10); // sqrt(1000 / 10)
        row("ATT", "10 0", 4);   // 3.16: rounded down to 3, which is less
        row("ATT", "0 12", 4);   // 3.79: rounded up
        row("ATT", "0 0", 0);
    }
    void planeDistancesAreRoundedByType()
    {
        QFETCH(const QByteArray, type);
        QFETCH(const QByteArray, place);
        QFETCH(const double, distance);
        const Eigen::MatrixXd d =
            read(placesText(type.toStdString(), "1 0 0\n2 " + place.toStdString() + '\n', 2))
                .problem.distance_m;
        QCOMPARE(d(0, 1), distance);
        QCOMPARE(d(1, 0), distance);
    }

    void planeInstancesAreSolvedToTheirOptima_data()
    {
        QTest::addColumn<std::function<int(double)>>("rounded");
        // The square of a distance between whole coordinates is exact.
        QTest::newRow("EUC_2D") << std::function([](double square) {
            int d = 0;
            while ((d + 0.5) * (d + 0.5) <= square)
                ++d;
            return d;
        });
        const std::function<int(double)> up = [](double square) {
            int d = 0;
            while (d * d < square)
                ++d;
            return d;
        };
        QTest::newRow("CEIL_2D") << up;
        QTest::newRow("ATT") << std::function([](double square) {
            int d = 0;
            while (10 * d * d < square)
                ++d;
            return d;
        });
    }
    void planeInstancesAreSolvedToTheirOptima()
    {
        QFETCH(const std::function<int(double)>, rounded);
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            Random random(seed, 6);
            constexpr std::size_t kCount = 7;
            std::vector<std::array<int, 2>> places(kCount);
            std::string rows;
            for (std::size_t i = 0; i < kCount; ++i) {
                places[i] = {static_cast<int>(random.below(200)) - 100,
                             static_cast<int>(random.below(200))};
                rows += std::to_string(i + 1) + ' ' + std::to_string(places[i][0]) + ' ' +
                        std::to_string(places[i][1]) + '\n';
            }
            Matrix expected(kCount, std::vector<int>(kCount, 0));
            for (std::size_t i = 0; i < kCount; ++i)
                for (std::size_t j = 0; j < kCount; ++j) {
                    const int dx = places[i][0] - places[j][0];
                    const int dy = places[i][1] - places[j][1];
                    expected[i][j] = rounded(dx * dx + dy * dy);
                }
            const TvpProblem problem =
                read(placesText(QTest::currentDataTag(), rows, kCount)).problem;
            checkMatrix(problem.distance_m, expected);
            checkOptima(problem);
        }
    }

    /** Degrees are truncated at the point and the rest is minutes, in the south and west too. */
    void geographicDistancesAgreeWithHaversines()
    {
        // Degrees and minutes of latitude and longitude.
        const std::vector<std::array<int, 4>> places{{59, 54, 10, 45},   {-33, 51, 151, 12},
                                                     {64, 8, -21, 56},   {1, 17, 103, 51},
                                                     {-54, 48, -68, 18}, {78, 13, 15, 38}};
        std::string rows;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const auto [latitude, minutes, longitude, minutesEast] = places[i];
            rows += QString::asprintf("%zu %d.%02d %d.%02d\n", i + 1, latitude, minutes, longitude,
                                      minutesEast)
                        .toStdString();
        }
        const TvpProblem problem =
            read(placesText("GEO", rows, static_cast<int>(places.size()))).problem;
        for (std::size_t i = 0; i < places.size(); ++i)
            for (std::size_t j = 0; j < places.size(); ++j) {
                if (i == j)
                    continue;
                const auto& a = places[i];
                const auto& b = places[j];
                const double km = haversine_km(radians(a[0], a[1]), radians(a[2], a[3]),
                                               radians(b[0], b[1]), radians(b[2], b[3]));
                // No value is so near a whole number that rounding could matter.
                QVERIFY(std::abs(km - std::round(km)) > 1e-6);
                QCOMPARE(
                    problem.distance_m(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)),
                    std::floor(km) + 1);
            }
        checkOptima(problem);
        // The format makes two nodes at one place a kilometre apart.
        QCOMPARE(
            read(placesText("GEO", "1 50.30 7.15\n2 50.30 7.15\n", 2)).problem.distance_m(0, 1),
            1.0);
    }

    void largestInstanceIsRead()
    {
        const Matrix matrix(1000, std::vector<int>(1000, 3));
        const TvpProblem problem = read(explicitText(matrix, "UPPER_DIAG_ROW", 17)).problem;
        QCOMPARE(problem.nodeCount(), 1000);
        QCOMPARE(problem.distance_m.sum(), 3.0 * 1000 * 999);
    }
};

QTEST_APPLESS_MAIN(TestTsplibWeights)
#include "tst_tsplib_weights.moc"
