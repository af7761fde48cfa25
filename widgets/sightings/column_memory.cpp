#include "widgets/sightings/column_memory.h"

#include <QCryptographicHash>
#include <QSettings>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr std::size_t kMostRemembered = 50;
constexpr auto kArray = "import/columns"_L1;

/** Settings text of one mapped column: "latitude=up". */
QString entryOf(const FieldColumn& mapped)
{
    return QString::fromStdString(nameOf(kSightingFieldNames, mapped.field)) + u'=' +
           QString::fromStdString(mapped.column);
}

ColumnMapping mappingOf(const QStringList& entries)
{
    ColumnMapping mapping;
    for (const QString& entry : entries) {
        const std::optional<SightingField> field =
            valueOf(kSightingFieldNames, entry.section(u'=', 0, 0).toStdString());
        const QString column = entry.section(u'=', 1);
        if (field && !column.isEmpty())
            mapping.push_back({.field = *field, .column = column.toStdString()});
    }
    return mapping;
}

void write(QSettings& settings, const std::vector<RememberedColumns>& all)
{
    settings.remove(kArray);
    settings.beginWriteArray(kArray, static_cast<int>(all.size()));
    for (std::size_t i = 0; i < all.size(); ++i) {
        settings.setArrayIndex(static_cast<int>(i));
        settings.setValue("header"_L1, all[i].header);
        QStringList entries;
        for (const FieldColumn& mapped : all[i].mapping)
            entries << entryOf(mapped);
        settings.setValue("fields"_L1, entries);
    }
    settings.endArray();
}

} // namespace

QString headerFingerprint(const QStringList& header)
{
    QStringList names;
    for (const QString& name : header)
        names << name.simplified().toCaseFolded();
    const QByteArray text = names.join(u'\n').toUtf8();
    return QString::fromLatin1(
        QCryptographicHash::hash(text, QCryptographicHash::Sha256).toHex().left(16));
}

std::vector<RememberedColumns> rememberedColumns(const QSettings& settings)
{
    std::vector<RememberedColumns> all;
    const int count = settings.value(kArray + "/size"_L1).toInt();
    for (int i = 1; i <= std::min(count, static_cast<int>(kMostRemembered)); ++i) {
        const QString group = kArray + u'/' + QString::number(i) + u'/';
        const QStringList header = settings.value(group + "header"_L1).toStringList();
        ColumnMapping mapping = mappingOf(settings.value(group + "fields"_L1).toStringList());
        if (!header.isEmpty() && !mapping.empty())
            all.push_back({.fingerprint = headerFingerprint(header),
                           .header = header,
                           .mapping = std::move(mapping)});
    }
    return all;
}

ColumnMapping columnsFor(const QSettings& settings, const QStringList& header)
{
    const QString fingerprint = headerFingerprint(header);
    for (RememberedColumns& known : rememberedColumns(settings))
        if (known.fingerprint == fingerprint)
            return std::move(known.mapping);
    return {};
}

void rememberColumns(QSettings& settings, const QStringList& header, const ColumnMapping& mapping)
{
    RememberedColumns added{
        .fingerprint = headerFingerprint(header), .header = header, .mapping = mapping};
    std::vector<RememberedColumns> all = rememberedColumns(settings);
    std::erase_if(all, [&](const RememberedColumns& known) {
        return known.fingerprint == added.fingerprint;
    });
    all.insert(all.begin(), std::move(added));
    all.resize(std::min(all.size(), kMostRemembered));
    write(settings, all);
}

void forgetColumns(QSettings& settings, const QString& fingerprint)
{
    std::vector<RememberedColumns> all = rememberedColumns(settings);
    std::erase_if(all,
                  [&](const RememberedColumns& known) { return known.fingerprint == fingerprint; });
    write(settings, all);
}

} // namespace berg
