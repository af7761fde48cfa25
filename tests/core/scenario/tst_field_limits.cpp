#include "core/base/number_text.h"
#include "core/io/files/scenario_json.h"
#include "core/io/results/result_csv.h"
#include "core/scenario/fields.h"
#include "tests/support/expect_error.h"

#include <QtTest>

#include <cmath>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/** A number with limits. */
struct Row
{
    QString field; ///< "uavs[].airspeed_mps"
    Limits limits;
};

std::vector<Row> rowsOfTheTables()
{
    std::vector<Row> rows;
    forEachObject([&rows](const std::string& object, const auto& fields) {
        for (const auto& field : fields)
            if (field.limits && field.limits->high < std::numeric_limits<double>::max() &&
                field.name != std::string_view("area_m")) // corners
                rows.push_back({QString::fromStdString(object + field.name), *field.limits});
    });
    return rows;
}

/** A scenario with this value in the field, in both numbers of a pair. */
std::string scenarioWith(const QString& field, double value)
{
    const QStringList objects{u"origin"_s, u"observer"_s, u"planner"_s, u"weather"_s};
    const QStringList pairs{u"position_m"_s, u"velocity_mps"_s, u"fov_m"_s,
                            u"home_m"_s,     u"current_mps"_s,  u"wind_mps"_s};
    const bool isForecast = field.startsWith(u"forecast."_s);
    const QString owner =
        field.contains(u'.') && !isForecast ? field.section(u'.', 0, -2) : QString();
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
    if (owner == u"ice_chart.areas[]"_s)
        members
            << u"\"ice_chart\": {\"areas\": [{\"outlines_m\": [[[0, 0], [9, 0], [0, 9]]], %1}]}"_s
                   .arg(text);
    if (owner == u"airspace[]"_s)
        members << u"\"airspace\": [{\"area_m\": [[0, 0], [9, 0], [0, 9]], %1}]"_s.arg(text);
    if (owner == u"no_fly[]"_s)
        members << u"\"no_fly\": [{\"area_m\": [[0, 0], [9, 0], [0, 9]], %1}]"_s.arg(text);
    if (isForecast) {
        const bool isEntry = field.contains(u"series"_s);
        QStringList place;
        for (const QString& coordinate : {u"latitude_deg"_s, u"longitude_deg"_s})
            if (name != coordinate)
                place << u"\"%1\": 0"_s.arg(coordinate);
        if (!isEntry)
            place << text;
        place << u"\"series\": [{\"time\": \"2026-01-01T00:00Z\"%1}]"_s.arg(isEntry ? u", "_s + text
                                                                                    : QString());
        members << u"\"start_utc\": \"2026-01-02T00:00Z\""_s
                << u"\"forecast\": {\"places\": [{%1}]}"_s.arg(place.join(u", "_s));
    } else if (owner.isEmpty())
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
    /** Files may hold exactly the values that the tables permit. */
    void filesMayHoldWhatTheTablesSay_data()
    {
        QTest::addColumn<QString>("field");
        QTest::addColumn<double>("low");
        QTest::addColumn<double>("high");
        QTest::addColumn<bool>("above");
        for (const auto& [field, limits] : rowsOfTheTables())
            QTest::newRow(qPrintable(field)) << field << limits.low << limits.high << limits.above;
    }

    void filesMayHoldWhatTheTablesSay()
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
};

QTEST_APPLESS_MAIN(TestFieldLimits)
#include "tst_field_limits.moc"
