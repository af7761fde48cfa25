#pragma once

#include <QByteArray>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QJsonValue>
#include <QString>

#include <algorithm>
#include <cmath>
#include <string>

namespace berg::test {

inline QByteArray bytes(const std::string& text)
{
    return QByteArray(text.data(), static_cast<qsizetype>(text.size()));
}

/**
 * Returns the content of tests/data/golden/`name`; with BERG_UPDATE_GOLDEN set, writes `actual`.
 */
inline QByteArray golden(const QString& name, const QByteArray& actual)
{
    QFile file(QStringLiteral(BERG_TEST_DATA "/golden/") + name);
    if (qEnvironmentVariableIsSet("BERG_UPDATE_GOLDEN") && file.open(QIODevice::WriteOnly)) {
        file.write(actual);
        file.close();
    }
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

inline bool near(double a, double b, double tolerance)
{
    return std::abs(a - b) <= tolerance * std::max({1.0, std::abs(a), std::abs(b)});
}

/**
 * Returns the path of the first difference between two JSON values, or an empty text. Numbers may
 * differ by `tolerance`, absolute below 1 and relative above.
 */
inline QString difference(const QJsonValue& a, const QJsonValue& b, double tolerance,
                          const QString& path = {})
{
    if (a.type() != b.type())
        return path + QStringLiteral(": types differ");
    if (a.isDouble())
        return near(a.toDouble(), b.toDouble(), tolerance)
                   ? QString()
                   : path + QStringLiteral(": %1, %2").arg(a.toDouble()).arg(b.toDouble());
    if (a.isArray()) {
        const QJsonArray left = a.toArray();
        const QJsonArray right = b.toArray();
        if (left.size() != right.size())
            return path + QStringLiteral(": lengths differ");
        for (qsizetype i = 0; i < left.size(); ++i) {
            const QString inner =
                difference(left[i], right[i], tolerance, path + QStringLiteral("[%1]").arg(i));
            if (!inner.isEmpty())
                return inner;
        }
        return {};
    }
    if (a.isObject()) {
        const QJsonObject left = a.toObject();
        const QJsonObject right = b.toObject();
        if (left.keys() != right.keys())
            return path + QStringLiteral(": members differ");
        for (const QString& key : left.keys()) {
            const QString inner =
                difference(left[key], right[key], tolerance, path + QLatin1Char('.') + key);
            if (!inner.isEmpty())
                return inner;
        }
        return {};
    }
    return a == b ? QString() : path + QStringLiteral(": values differ");
}

/**
 * Returns the first difference between two texts of lines and fields split by `separator`; fields
 * that are numbers may differ by `tolerance`.
 */
inline QString tableDifference(const QByteArray& a, const QByteArray& b, char separator,
                               double tolerance)
{
    const QList<QByteArray> left = a.split('\n');
    const QList<QByteArray> right = b.split('\n');
    if (left.size() != right.size())
        return QStringLiteral("numbers of lines differ");
    for (qsizetype row = 0; row < left.size(); ++row) {
        const QList<QByteArray> leftFields = left[row].split(separator);
        const QList<QByteArray> rightFields = right[row].split(separator);
        if (leftFields.size() != rightFields.size())
            return QStringLiteral("line %1: numbers of fields differ").arg(row + 1);
        for (qsizetype i = 0; i < leftFields.size(); ++i) {
            bool leftNumber = false;
            bool rightNumber = false;
            const double x = leftFields[i].toDouble(&leftNumber);
            const double y = rightFields[i].toDouble(&rightNumber);
            const bool equal =
                leftNumber && rightNumber ? near(x, y, tolerance) : leftFields[i] == rightFields[i];
            if (!equal)
                return QStringLiteral("line %1, field %2").arg(row + 1).arg(i + 1);
        }
    }
    return {};
}

} // namespace berg::test
