#include "core/base/error.h"
#include "core/io/import/maps/feature_parsers.h"
#include "core/io/import/maps/feature_sightings.h"
#include "core/io/import/maps/kmz_documents.h"
#include "core/io/import/maps/map_readers.h"
#include "core/io/text/zip_file.h"

#include <vector>

namespace berg {

namespace {

/** Adds the features of a document; its links are returned even if the document is broken. */
void readDocument(FeatureSightings& found, std::string_view text, ReadBudget& budget,
                  std::vector<KmlText>& links)
{
    readKmlFeatures(text, budget,
                    {.feature = [&found](const FileFeature& feature) { found.add(feature); },
                     .link = [&links](const KmlText& link) { links.push_back(link); }});
}

void rejectLink(FeatureSightings& found, const KmlText& link)
{
    found.reject(
        {.line = link.line, .fault = IssueId::LinkNotRead, .detail = cleanText(link.text, 200)});
}

/** Adds the name of a document of an archive to the rows from `from` on. */
void nameDocument(Rejections& rows, std::size_t from, const std::string& name)
{
    for (std::size_t i = from; i < rows.first.size(); ++i) {
        std::string& detail = rows.first[i].detail;
        detail.insert(0, cleanText(name, 200).append(detail.empty() ? "" : ": "));
    }
}

void readPacked(FeatureSightings& found, KmzDocuments& documents, const KmzDocument& document,
                ReadBudget& budget)
{
    std::vector<KmlText> links;
    try {
        const std::string text = documents.text(document.name);
        readDocument(found, text, budget, links);
        documents.release(text);
    } catch (const Error& error) {
        const bool isBroken =
            error.code() == ErrorCode::SyntaxError || error.code() == ErrorCode::WrongFormat;
        if (documents.count() == 1 || !isBroken)
            throw;
        found.reject({.line = 1, .fault = IssueId::DocumentBroken});
    }
    for (const KmlText& link : links)
        if (!documents.follow(link.text, document.name))
            rejectLink(found, link);
}

/** Reads each document of an archive once. */
void readArchive(FeatureSightings& found, const ImportText& source)
{
    KmzDocuments documents(source.text, source.budget);
    SightingTable& table = found.table();
    while (const std::optional<KmzDocument> document = documents.next()) {
        const std::size_t rejected = table.rejected.first.size();
        const std::size_t noted = table.noted.first.size();
        if (!document->isLinked)
            table.noted.add({.line = 1, .fault = IssueId::DocumentUnlinked, .detail = {}});
        readPacked(found, documents, *document, source.budget);
        if (documents.count() == 1)
            continue;
        nameDocument(table.rejected, rejected, document->name);
        nameDocument(table.noted, noted, document->name);
    }
    for (const std::string& name : documents.archives())
        found.reject(
            {.line = 1, .fault = IssueId::ArchiveInArchive, .detail = cleanText(name, 200)});
}

} // namespace

SightingTable readKml(const ImportText& source)
{
    FeatureSightings found(source);
    if (isZip(source.text)) {
        readArchive(found, source);
        return found.take();
    }
    std::vector<KmlText> links;
    readDocument(found, source.text, source.budget, links);
    for (const KmlText& link : links)
        rejectLink(found, link);
    return found.take();
}

bool isKml(std::string_view text)
{
    return rootIs(text, "kml");
}

} // namespace berg
