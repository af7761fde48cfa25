#include "core/io/files/certificate_json.h"
#include "core/plan/fleet/fleet_solver.h"
#include "core/plan/solve/order_moves.h"
#include "tests/support/plan/fleet_problems.h"
#include "tests/support/plan/hard_problems.h"
#include "tests/support/plan/reference_optimum.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <map>
#include <optional>
#include <set>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/** JsonPath to a value in a document: names of members and indices of entries. */
using JsonPath = QStringList;

/** The path with every index replaced by a star: the kind of the value. */
QString kindOf(JsonPath path)
{
    for (QString& part : path)
        if (part.front().isDigit())
            part = u"*"_s;
    return path.join(u'/');
}

void collect(const QJsonValue& value, const JsonPath& path,
             std::map<QString, std::vector<JsonPath>>& found)
{
    if (!path.isEmpty())
        found[kindOf(path)].push_back(path);
    if (value.isObject()) {
        const QJsonObject object = value.toObject();
        for (auto it = object.begin(); it != object.end(); ++it)
            collect(it.value(), path + JsonPath{it.key()}, found);
    } else if (value.isArray()) {
        const QJsonArray array = value.toArray();
        for (qsizetype i = 0; i < array.size(); ++i)
            collect(array.at(i), path + JsonPath{QString::number(i)}, found);
    }
}

QJsonValue valueAt(const QJsonValue& root, const JsonPath& path)
{
    if (path.isEmpty())
        return root;
    return valueAt(root.isObject() ? root.toObject().value(path.front())
                                   : root.toArray().at(path.front().toInt()),
                   path.mid(1));
}

/** Returns the document with another value at that path; an undefined value removes it. */
QJsonValue with(const QJsonValue& root, const JsonPath& path, const QJsonValue& value)
{
    if (path.isEmpty())
        return value;
    const QJsonValue inner = with(valueAt(root, path.first(1)), path.mid(1), value);
    if (root.isObject()) {
        QJsonObject object = root.toObject();
        object[path.front()] = inner; // an undefined one removes the member
        return object;
    }
    QJsonArray array = root.toArray();
    if (inner.isUndefined())
        array.removeAt(path.front().toInt());
    else
        array[path.front().toInt()] = inner;
    return array;
}

QString anyClaim(Random& random)
{
    const QStringList claims{u"the orders are optimal"_s,
                             u"the orders are optimal "_s,
                             u"the orders are within 0.001 % of optimal"_s,
                             u"the orders are within % of optimal"_s,
                             u"the orders are within 1e9 % of optimal"_s,
                             u"the orders are within nan % of optimal"_s,
                             u"the orders are within -1 % of optimal"_s,
                             u"the orders are within 5 % of optimal, or optimal"_s,
                             u"the orders are fine"_s};
    const auto k = random.below(static_cast<std::uint64_t>(2 * claims.size()));
    if (k < static_cast<std::uint64_t>(claims.size()))
        return claims[static_cast<qsizetype>(k)];
    const double percent = std::exp(random.uniform(-12, 6));
    return u"the orders are within %1 % of optimal"_s.arg(percent, 0, 'f', 6);
}

QJsonValue changedNumber(double number, Random& random)
{
    switch (random.below(7)) {
    case 0:
        return -number - 1;
    case 1:
        return number + (random.below(2) == 0 ? 1 : -1);
    case 2:
        return 0;
    case 3:
        return QString::number(number);
    case 4:
        return number * (1 + random.uniform(-1e-7, 1e-7));
    default:
        return number * std::exp(random.uniform(-1, 1));
    }
}

QJsonValue changedArray(QJsonArray array, Random& random)
{
    if (array.isEmpty())
        return QJsonArray{0};
    const auto size = static_cast<std::uint64_t>(array.size());
    const auto a = static_cast<qsizetype>(random.below(size));
    const auto b = static_cast<qsizetype>(random.below(size));
    const QJsonValue kept = array[a];
    switch (random.below(5)) {
    case 0:
        array.removeAt(a);
        break;
    case 1:
        array.insert(a, QJsonValue(array[b]));
        break;
    case 2:
        return QJsonArray();
    default:
        array[a] = QJsonValue(array[b]);
        array[b] = kept;
    }
    return array;
}

QJsonValue changed(const QJsonValue& value, const QString& kind, Random& random)
{
    if (kind.endsWith("/claim") && random.below(5) != 0)
        return anyClaim(random);
    if (random.below(12) == 0)
        return random.below(2) == 0 ? QJsonValue(QJsonValue::Undefined) : QJsonValue();
    if (value.isDouble())
        return changedNumber(value.toDouble(), random);
    if (value.isBool())
        return !value.toBool();
    if (value.isArray())
        return changedArray(value.toArray(), random);
    const QStringList words{u"visitation"_s,  u"latency"_s,    u"open"_s, u"closed"_s,
                            u"enumeration"_s, u"sorting"_s,    u"1f"_s,   u"0"_s,
                            u"fff"_s,         u"relaxation"_s, u""_s};
    return words[static_cast<qsizetype>(random.below(static_cast<std::uint64_t>(words.size())))];
}

std::vector<double> numbersOf(const QJsonValue& value)
{
    std::vector<double> numbers;
    for (const QJsonValue& number : value.toArray())
        numbers.push_back(number.toDouble());
    return numbers;
}

/** Returns the problem in the document, or nullopt if it holds none. */
std::optional<FleetProblem> problemOf(const QJsonObject& root)
{
    FleetProblem problem{.sigma_m2 = numbersOf(root["sigma"])};
    const auto n = static_cast<Eigen::Index>(problem.sigma_m2.size());
    for (const QJsonValue& matrix : root["distance_m"].toArray()) {
        Eigen::MatrixXd& distance_m = problem.distance_m.emplace_back(n, n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const std::vector<double> row = numbersOf(matrix.toArray().at(i));
            if (static_cast<Eigen::Index>(row.size()) != n)
                return std::nullopt;
            for (Eigen::Index j = 0; j < n; ++j)
                distance_m(i, j) = row[static_cast<std::size_t>(j)];
        }
    }
    for (const QJsonValue& row : root["allowed"].toArray()) {
        problem.allowed.emplace_back();
        for (const QJsonValue& may : row.toArray())
            problem.allowed.back().push_back(may.toBool());
        problem.allowed.back().resize(problem.sigma_m2.size(), false);
    }
    if (!problem.allowed.empty() && problem.allowed.size() < problem.distance_m.size())
        return std::nullopt;
    const QString criterion = root["criterion"].toString();
    const QString route = root["route"].toString();
    const bool isKnown = (criterion == u"latency" || criterion == u"visitation") &&
                         (route == u"open" || route == u"closed") &&
                         root["format"].toString() == u"bergwatch-certificate" &&
                         root["version"].toDouble() == 1;
    if (!isKnown || n == 0 || problem.distance_m.empty() || problem.sigma_m2[0] != 0)
        return std::nullopt;
    problem.criterion = criterion == u"latency" ? Criterion::Latency : Criterion::Visitation;
    problem.route = route == u"closed" ? Route::Closed : Route::Open;
    return problem;
}

/**
 * Computes the optimum by dynamic programming, once for each problem: most changes leave it the
 * same.
 */
double optimumOf(const FleetProblem& problem)
{
    static std::map<std::vector<double>, double> known;
    std::vector<double> key = problem.sigma_m2;
    key.insert(key.end(), {problem.mu, static_cast<double>(problem.route),
                           static_cast<double>(problem.criterion)});
    for (const Eigen::MatrixXd& distance_m : problem.distance_m)
        key.insert(key.end(), distance_m.reshaped().begin(), distance_m.reshaped().end());
    for (const std::vector<bool>& row : problem.allowed)
        key.insert(key.end(), row.begin(), row.end());
    const auto [place, isNew] = known.try_emplace(std::move(key), 0);
    if (isNew)
        place->second = static_cast<double>(test::referenceFleetCost(problem));
    return place->second;
}

FleetPlan planOf(const QJsonValue& proof)
{
    FleetPlan plan;
    for (const QJsonValue& order : proof.toObject()["orders"].toArray()) {
        plan.emplace_back();
        for (const double node : numbersOf(order))
            plan.back().push_back(NodeIndex::of(static_cast<int>(node)));
    }
    return plan;
}

/**
 * Returns by how much, relative to their cost, the claim lets the orders exceed the optimum;
 * negative without a claim.
 */
double claimedGap(const QString& claim)
{
    if (claim == u"the orders are optimal")
        return 1e-8;
    static const QRegularExpression kWithin(
        u"^the orders are within ([0-9]*\\.?[0-9]*) % of optimal$"_s);
    const QRegularExpressionMatch match = kWithin.match(claim);
    bool isNumber = false;
    const double percent = match.captured(1).toDouble(&isNumber);
    return match.hasMatch() && isNumber ? percent / 100 : -1;
}

/**
 * Returns the false statement of the proof, as found by dynamic programming; empty if there is
 * none.
 */
QString untruthOf(FleetProblem problem, const QJsonValue& value)
{
    const QJsonObject proof = value.toObject();
    problem.mu = proof["mu"].toDouble();
    const FleetPlan plan = planOf(value);
    if (!isFleetPlan(problem, plan))
        return u"the orders are no plan"_s;
    const double cost = fleetObjective(problem, plan) + objectiveShift(problem);
    const double optimum = optimumOf(problem);
    const double rounding = 1e-9 * (1 + cost);
    if (cost > proof["cost"].toDouble() + rounding)
        return u"the orders cost more: %1"_s.arg(cost);
    if (proof["bound"].toDouble() > optimum + rounding)
        return u"the bound is above the optimum %1"_s.arg(optimum);
    if (cost - optimum > claimedGap(proof["claim"].toString()) * cost + rounding)
        return u"the optimum is %1, the cost %2"_s.arg(optimum).arg(cost);
    return {};
}

/** Corrects cost and bound of the first proof, whatever it claims. */
QJsonValue honest(const QJsonValue& root)
{
    const std::optional<FleetProblem> read = problemOf(root.toObject());
    const JsonPath proof{u"proofs"_s, u"0"_s};
    const FleetPlan plan = planOf(valueAt(root, proof));
    if (!read)
        return root;
    FleetProblem problem = *read;
    problem.mu = valueAt(root, proof + JsonPath{u"mu"_s}).toDouble();
    if (!isFleetPlan(problem, plan) || problem.icebergCount() > 8)
        return root;
    const double cost = fleetObjective(problem, plan) + objectiveShift(problem);
    const double optimum = optimumOf(problem);
    return with(with(root, proof + JsonPath{u"cost"_s}, cost), proof + JsonPath{u"bound"_s},
                std::min(cost, optimum) * (1 - 1e-9));
}

Certificate certificateOf(const FleetProblem& problem, const FleetPlan& plan)
{
    return {.problem = problem, .proofs = {certify(problem, plan)}};
}

/**
 * Returns valid certificates: each proof method, one UAV and several, good orders and poor ones.
 */
Certificate sound(int k)
{
    const auto seed = static_cast<std::uint64_t>(k);
    if (k % 4 == 3) {
        const auto kind = static_cast<test::FleetKind>(k / 4 % 5);
        const FleetProblem problem = test::randomFleet(seed, 2, 4 + k % 3, 1, kind);
        FleetPlan plan(2);
        for (const NodeIndex i : icebergNodes(problem.icebergCount()))
            plan[problem.allows(0, i) ? 0 : 1].push_back(i);
        return certificateOf(problem, plan);
    }
    const bool isLarge = k % 16 == 4;
    const TvpProblem problem = k % 4 == 2
                                   ? test::variedLatencyProblem(k % 16 == 6 ? 15 : 4 + k % 4, k)
                                   : test::variedProblem(isLarge ? 15 : 3 + k % 4, k);
    const VisitOrder order =
        k % 3 == 0 ? sigmaOrder(problem) : makeSolver(Backend::Exact)->solve(problem, {}).order();
    return {.problem = berg::problemOf(problem), .proofs = {certify(problem, order)}};
}

} // namespace

/** Changes certificates at random: the claims that the checker accepts must be true. */
class TestCertificateMutants : public QObject
{
    Q_OBJECT

private slots:
    /** The order is the worst of six; cost and bound are right, the claim is not. */
    void falseClaimsAreRefused_data()
    {
        QTest::addColumn<QString>("claim");
        QTest::addColumn<bool>("isTrue");
        const auto row = [](const QString& number, bool isTrue) {
            QTest::newRow(qPrintable(number))
                << u"the orders are within %1 % of optimal"_s.arg(number) << isTrue;
        };
        row(u"0.001"_s, false);
        row(u"26.8"_s, false); // it is 26.842
        row(u"26.9"_s, true);
        row(u"99"_s, true);
        row(u""_s, false);
        row(u"inf"_s, false);
        row(u"1e3"_s, false);
        row(u"99 or 0.1"_s, false);
        QTest::newRow("other words") << u"the orders are within reach"_s << false;
        QTest::newRow("optimal") << u"the orders are optimal"_s << false;
    }
    void falseClaimsAreRefused()
    {
        QFETCH(const QString, claim);
        QFETCH(const bool, isTrue);
        FleetProblem problem{.sigma_m2 = {0, 9, 1, 4}, .mu = 0.003757382148243401};
        const double far_m = std::sqrt(1e7);
        problem.distance_m.emplace_back(4, 4);
        problem.distance_m[0] << 0, 1000, 3000, far_m, 1000, 0, 4000, 3000, 3000, 4000, 0, 5000,
            far_m, 3000, 5000, 0;
        const QJsonValue root = parsed(certificateJson(certificateOf(problem, {{3, 2, 1}})));
        const QString said = valueAt(root, {u"proofs"_s, u"0"_s, u"claim"_s}).toString();
        QCOMPARE(said, u"the orders are within 26.9 % of optimal"_s);
        write(0, with(root, {u"proofs"_s, u"0"_s, u"claim"_s}, claim));
        QCOMPARE(accepted(1).size(), isTrue ? 1U : 0U);
    }

    /**
     * Makes 4,000 changes to values of every kind, some with cost and bound corrected afterwards.
     */
    void acceptedClaimsAreTrue()
    {
        constexpr int kSound = 40;
        constexpr int kOfEach = 100;
        std::map<QString, int> changes;
        int acceptances = 0;
        for (int k = 0; k < kSound; ++k) {
            Random random(static_cast<std::uint64_t>(k), 301);
            const QJsonValue root = parsed(certificateJson(sound(k)));
            std::map<QString, std::vector<JsonPath>> found;
            collect(root, {}, found);
            write(0, root);
            QCOMPARE(accepted(1).size(), 1U);
            std::vector<QJsonValue> mutants;
            for (int m = 0; m < kOfEach; ++m) {
                auto kind = found.begin();
                std::advance(kind, static_cast<int>(random.below(found.size())));
                const std::vector<JsonPath>& paths = kind->second;
                const JsonPath& path = paths[random.below(paths.size())];
                QJsonValue mutant =
                    with(root, path, changed(valueAt(root, path), kind->first, random));
                ++changes[kind->first];
                if (random.below(2) == 0)
                    mutant = honest(mutant);
                write(m, mutant);
                mutants.push_back(mutant);
            }
            for (const int m : accepted(kOfEach)) {
                const QJsonObject mutant = mutants[static_cast<std::size_t>(m)].toObject();
                const std::optional<FleetProblem> problem = problemOf(mutant);
                QVERIFY2(problem, text(mutant).constData());
                for (const QJsonValue& proof : mutant["proofs"].toArray()) {
                    const QString untruth = untruthOf(*problem, proof);
                    QVERIFY2(untruth.isEmpty(),
                             qPrintable(untruth + u": "_s + QString::fromUtf8(text(mutant))));
                }
                ++acceptances;
            }
        }
        // A certificate has 29 kinds of member and entry, and three lists of lists.
        QCOMPARE(changes.size(), 32U);
        for (const auto& [kind, count] : changes)
            QVERIFY2(count > 3, qPrintable(kind));
        QVERIFY2(acceptances > 400, qPrintable(QString::number(acceptances)));
    }

private:
    static QJsonValue parsed(const std::string& text)
    {
        return QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
    }
    static QByteArray text(const QJsonObject& root)
    {
        return QJsonDocument(root).toJson(QJsonDocument::Compact);
    }
    [[nodiscard]] QString fileName(int k) const { return m_dir.filePath(u"%1.json"_s.arg(k)); }
    void write(int k, const QJsonValue& root) const
    {
        QFile file(fileName(k));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QVERIFY(file.write(text(root.toObject())) > 0);
    }
    /** Returns which of the first files the checker accepts. */
    [[nodiscard]] std::set<int> accepted(int count) const
    {
        QStringList files;
        std::set<int> accepted;
        for (int k = 0; k < count; ++k) {
            files.append(fileName(k));
            accepted.insert(k);
        }
        QProcess process;
        process.start(QStringLiteral(BERG_CHECKER), files);
        process.waitForFinished(600'000);
        const QString output = QString::fromUtf8(process.readAllStandardOutput());
        if (process.exitStatus() != QProcess::NormalExit)
            return {-1};
        for (int k = 0; k < count; ++k)
            if (output.contains(fileName(k) + u": WRONG"_s) || !output.contains(fileName(k)))
                accepted.erase(k);
        return accepted;
    }

    QTemporaryDir m_dir;
};

QTEST_GUILESS_MAIN(TestCertificateMutants)
#include "tst_certificate_mutants.moc"
