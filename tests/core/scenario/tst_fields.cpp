#include "core/checks/findings.h"
#include "core/scenario/fields.h"
#include "core/scenario/text_checks.h"

#include <QtTest>

#include <set>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/** Returns the numbers of a value; empty if it has none. */
template <class Value>
std::vector<double> numbersOf(const Value& value)
{
    if constexpr (std::is_same_v<Value, double>)
        return {value};
    else if constexpr (std::is_same_v<Value, std::int64_t>)
        return {static_cast<double>(value)};
    else if constexpr (std::is_same_v<Value, Point>)
        return {value.x(), value.y()};
    else
        return {};
}

} // namespace

class TestFields : public QObject
{
    Q_OBJECT

private slots:
    void faultsOfAFieldAreThoseOfItsParts()
    {
        Findings findings(Findings::Kind::All);
        findings.error("icebergs[10].q_m2ps", IssueId::NotUtf8);
        QVERIFY(findings.has("icebergs[10]"));
        QVERIFY(findings.has("icebergs[10].q_m2ps"));
        QVERIFY(findings.has("icebergs"));
        QVERIFY(!findings.has("icebergs[1"));
        QVERIFY(!findings.has("icebergs[10].q"));
    }

    void fieldsOfAnObjectHaveDifferentNames()
    {
        forEachObject([](const std::string& object, const auto& fields) {
            std::set<std::string> names;
            for (const auto& field : fields)
                QVERIFY2(names.insert(field.name).second, (object + field.name).c_str());
        });
    }

    /** Findings and inputs need a label. The wind is limited by the airspeed only. */
    void numbersHaveLimitsAndLabels()
    {
        forEachObject([](const std::string& object, const auto& fields) {
            for (const auto& field : fields)
                if (field.quantity != Quantity::Text && field.quantity != Quantity::Utc) {
                    const std::string path = object + field.name;
                    QVERIFY2(field.limits || path == "wind_mps", path.c_str());
                    QVERIFY2(*field.label != 0, path.c_str());
                    QVERIFY2(!isPair(field) || *field.label2 != 0, path.c_str());
                }
        });
    }

    /** A file without the member is valid. */
    void defaultsAreInLimits()
    {
        forEachObject([]<class T>(const std::string& object, std::span<const Field<T>> fields) {
            const T standard;
            for (const Field<T>& field : fields)
                withField(field, standard, [&](const auto& value) {
                    for (const double number : numbersOf(value))
                        if (field.limits && !(field.traits.zeroIsNone && number == 0))
                            QVERIFY2(!outOfLimits(number, *field.limits),
                                     (object + field.name).c_str());
                });
        });
    }

    void fieldsBetweenTwoAreThoseOfTheTable()
    {
        const auto heights = between(fieldsOf<NoFlyArea>(), "floor_m", "ceiling_m");
        QCOMPARE(heights.size(), 2U);
        QCOMPARE(std::string(heights.front().name), "floor_m");
        QVERIFY_THROWS_EXCEPTION(std::logic_error, (void)between(fieldsOf<Uav>(), "id", "nothing"));
    }
};

QTEST_APPLESS_MAIN(TestFields)
#include "tst_fields.moc"
