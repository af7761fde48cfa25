#include "core/base/number_text.h"
#include "core/io/files/scenario_json.h"
#include "core/io/results/result_csv.h"
#include "core/scenario/limits.h"
#include "tests/support/expect_error.h"

#include <QFile>
#include <QRegularExpression>
#include <QtTest>

#include <cmath>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/** A row of the table of limits in the page about scenario files. */
struct Row
{
    QString field; ///< "uavs[].airspeed_mps"
    double low = 0;
    double high = 0;
    bool above = false;
};

QString thePage()
{
    QFile page(QStringLiteral(BERG_SOURCE_DIR "/resources/scenarios/README.md"));
    return page.open(QIODevice::ReadOnly) ? QString::fromUtf8(page.readAll()) : QString();
}

std::vector<Row> rowsOfThePage()
{
    static const QRegularExpression pattern(
        u"^\\| ([a-z0-9_.\\[\\]]+) \\| (above )?(-?[0-9.e]+) \\| (-?[0-9.e]+) \\|$"_s,
        QRegularExpression::MultilineOption);
    std::vector<Row> rows;
    auto matches = pattern.globalMatch(thePage());
    while (matches.hasNext()) {
        const QRegularExpressionMatch match = matches.next();
        rows.push_back({.field = match.captured(1),
                        .low = match.captured(3).toDouble(),
                        .high = match.captured(4).toDouble(),
                        .above = !match.captured(2).isEmpty()});
    }
    return rows;
}

/** A scenario with that value in the field, in both places of a pair. */
std::string scenarioWith(const QString& field, double value)
{
    const QStringList objects{u"origin"_s, u"observer"_s, u"planner"_s, u"weather"_s};
    const QStringList pairs{u"position_m"_s, u"velocity_mps"_s, u"fov_m"_s, u"current_mps"_s};
    const QString owner = field.contains(u'.') ? field.section(u'.', 0, 0) : QString();
    const QString name = field.section(u'.', -1);
    const QString number = QString::fromStdString(numberText(value));
    const QString text =
        u"\"%1\": "_s.arg(name) + (pairs.contains(name) ? u"[%1, %1]"_s.arg(number) : number);
    const auto object = [&](const QString& of) {
        const bool hasNoPlace = (name == u"position_m"_s && owner == of) || objects.contains(of);
        const QString place = hasNoPlace ? QString() : u"\"position_m\": [0, 0]"_s;
        QStringList members;
        if (!place.isEmpty())
            members << place;
        if (owner == of)
            members << text;
        return u"{%1}"_s.arg(members.join(u", "_s));
    };
    QStringList members{u"\"format\": \"bergwatch-scenario\", \"version\": 1"_s,
                        u"\"uavs\": [%1]"_s.arg(object(u"uavs[]"_s)),
                        u"\"icebergs\": [%1]"_s.arg(object(u"icebergs[]"_s)),
                        u"\"asset\": %1"_s.arg(object(u"asset"_s))};
    for (const QString& of : objects)
        if (owner == of)
            members << u"\"%1\": %2"_s.arg(of, object(of));
    if (owner == u"ground_station"_s)
        members << u"\"ground_station\": %1"_s.arg(object(owner));
    if (owner == u"operation"_s)
        members << u"\"operation\": {%1}"_s.arg(text);
    if (owner == u"airspace[]"_s)
        members << u"\"airspace\": [{\"area_m\": [[0, 0], [9, 0], [0, 9]], %1}]"_s.arg(text);
    if (owner == u"no_fly[]"_s)
        members << u"\"no_fly\": [{\"area_m\": [[0, 0], [9, 0], [0, 9]], %1}]"_s.arg(text);
    if (owner.isEmpty())
        members << text;
    return u"{%1}"_s.arg(members.join(u", "_s)).toStdString();
}

bool isRefused(const QString& field, double value)
{
    const std::string path = QString(field).replace(u"[]"_s, u"[0]"_s).toStdString();
    try {
        (void)scenarioFromJson(scenarioWith(field, value), "text");
    } catch (const Error& error) {
        return std::ranges::any_of(error.issues(), [&](const Issue& issue) {
            return issue.field == path || issue.field.starts_with(path + '[');
        });
    }
    return false;
}

} // namespace

class TestFieldLimits : public QObject
{
    Q_OBJECT

private slots:
    /** What the page says is what a file may hold, neither more nor less. */
    void thePageSaysWhatFilesMayHold_data()
    {
        QTest::addColumn<QString>("field");
        QTest::addColumn<double>("low");
        QTest::addColumn<double>("high");
        QTest::addColumn<bool>("above");
        for (const Row& row : rowsOfThePage())
            QTest::newRow(qPrintable(row.field)) << row.field << row.low << row.high << row.above;
    }

    void thePageSaysWhatFilesMayHold()
    {
        QFETCH(QString, field);
        QFETCH(double, low);
        QFETCH(double, high);
        QFETCH(bool, above);
        const bool isWhole = field == u"seed"_s;
        const auto below = [&](double value) {
            return isWhole ? value - 1 : std::nextafter(value, -INFINITY);
        };
        const auto beyond = [&](double value) {
            return isWhole ? value + 2 : std::nextafter(value, INFINITY);
        };
        QCOMPARE(isRefused(field, low), above);
        QVERIFY(!isRefused(field, beyond(low)));
        QVERIFY(!isRefused(field, high));
        QVERIFY(isRefused(field, below(low)));
        QVERIFY(isRefused(field, beyond(high)));
    }

    void thePageHasThemAll() { QCOMPARE(rowsOfThePage().size(), 68U); }

    void thePageNamesThePolicies()
    {
        const QString names = QString::fromStdString(allowedNames(kPolicyNames));
        QVERIFY(thePage().contains(u"\n| planner.policy | visitation | %1 |\n"_s.arg(names)));
    }
};

QTEST_APPLESS_MAIN(TestFieldLimits)
#include "tst_field_limits.moc"
