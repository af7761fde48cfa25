#include "core/io/import/maps/kmz_documents.h"

#include "core/base/error.h"
#include "core/io/import/fields/import_xml.h"

#include <charconv>
#include <filesystem>

namespace berg {

namespace {

/**
 * Returns the name of the entry to which a link in a document points; empty if it is outside the
 * archive.
 */
std::string entryOf(const std::string& href, const std::string& document)
{
    if (href.find(':') != std::string::npos || href.starts_with('/') || href.starts_with('\\'))
        return {};
    const std::size_t folder = document.rfind('/');
    std::string path = folder == std::string::npos ? "" : document.substr(0, folder + 1);
    for (std::size_t i = 0; i < href.size() && href[i] != '#' && href[i] != '?'; ++i) {
        unsigned byte = 0;
        const bool isCoded =
            href[i] == '%' && i + 2 < href.size() &&
            std::from_chars(&href[i] + 1, &href[i] + 3, byte, 16).ptr == &href[i] + 3;
        path += isCoded ? static_cast<char>(byte) : href[i] == '\\' ? '/' : href[i];
        i += isCoded ? 2 : 0;
    }
    const std::string plain = std::filesystem::path(path).lexically_normal().generic_string();
    return plain.starts_with("..") ? std::string() : plain;
}

} // namespace

KmzDocuments::KmzDocuments(std::string_view bytes, ReadBudget& budget)
    : m_budget(budget), m_archive(bytes, budget), m_names(m_archive.names(".kml"))
{
    if (m_names.empty())
        throw Error(ErrorCode::WrongFormat, budget.subject(), {IssueId::ArchiveWithout, {".kml"}});
    m_entries.insert(m_names.begin(), m_names.end());
    m_waiting.push_back(m_names.front());
    m_known.insert(m_names.front());
}

std::optional<KmzDocument> KmzDocuments::next()
{
    if (!m_waiting.empty()) {
        KmzDocument document{.name = std::move(m_waiting.front())};
        m_waiting.pop_front();
        return document;
    }
    while (m_read < m_names.size()) {
        const std::string& name = m_names[m_read++];
        if (m_known.insert(name).second)
            return KmzDocument{.name = name, .isLinked = false};
    }
    return std::nullopt;
}

std::string KmzDocuments::text(const std::string& name)
{
    std::string bytes = m_archive.text(name);
    if (isZip(bytes)) // some archives contain themselves
        throw Error(ErrorCode::WrongFormat, m_budget.subject(), {IssueId::ArchiveInArchive});
    std::string decoded = textOfXml(bytes, m_budget.subject());
    if (decoded.empty())
        return bytes;
    m_budget.take(decoded.capacity());
    m_budget.release(bytes.capacity());
    return decoded;
}

void KmzDocuments::release(const std::string& text)
{
    m_budget.release(text.capacity() - text.size());
}

bool KmzDocuments::follow(const std::string& link, const std::string& document)
{
    const std::string name = entryOf(link, document);
    if (!m_entries.contains(name))
        return false;
    if (m_known.insert(name).second)
        m_waiting.push_back(name);
    return true;
}

} // namespace berg
