#include "core/io/import/forecast/netcdf_file.h"

#include "core/base/error.h"
#include "core/io/text/read_budget.h"

#include <array>
#include <limits>
#include <netcdf.h>
#include <netcdf_mem.h>
#include <utility>

namespace berg {

namespace {

constexpr std::size_t kMostDimensions = 1000;
constexpr std::size_t kMostVariables = 10'000;
constexpr std::size_t kMostDimensionsOfOne = 8;
constexpr std::size_t kLongestText = 4096;
constexpr std::size_t kMostNumbers = 16;

[[noreturn]] void failNetcdf(const std::string& subject, const std::string& field, int status)
{
    // Positive numbers are those of the system, which say nothing about a file in memory.
    const IssueReason reason = status > 0 ? IssueReason{IssueId::Damaged}
                                          : IssueReason{IssueId::CannotRead, {nc_strerror(status)}};
    throw Error(ErrorCode::FileUnreadable, subject, {{Severity::Error, field, reason}});
}

/** Throws the error of a call that failed. */
void succeed(int status, const std::string& subject, const std::string& field)
{
    if (status != NC_NOERR)
        failNetcdf(subject, field, status);
}

bool isNumber(nc_type type)
{
    return type != NC_CHAR && type >= NC_BYTE && type <= NC_UINT64;
}

std::optional<double> defaultFillOf(nc_type type)
{
    switch (type) {
    case NC_SHORT:
        return NC_FILL_SHORT;
    case NC_INT:
        return NC_FILL_INT;
    case NC_FLOAT:
    case NC_DOUBLE:
        return NC_FILL_DOUBLE; // both are 2^123 * 15 / 16
    default:
        return std::nullopt; // every byte may be a value
    }
}

std::size_t bytesOf(nc_type type)
{
    switch (type) {
    case NC_BYTE:
    case NC_UBYTE:
        return 1;
    case NC_SHORT:
    case NC_USHORT:
        return 2;
    case NC_INT:
    case NC_UINT:
    case NC_FLOAT:
        return 4;
    default:
        return 8;
    }
}

} // namespace

struct NetcdfFile::Handle
{
    int id = 0;
};

NetcdfFile::NetcdfFile(std::string_view bytes, std::string subject)
    : m_subject(std::move(subject)), m_size(bytes.size())
{
    int id = 0;
    // The bytes are not written to: the mode says so, but the parameter cannot.
    void* const memory = const_cast<char*>(bytes.data());
    succeed(nc_open_mem("forecast.nc", NC_NOWRITE, bytes.size(), memory, &id), m_subject, {});
    m_handle = std::make_unique<Handle>(Handle{.id = id});
    try {
        readDimensions();
        readVariables();
    } catch (...) {
        (void)nc_close(id);
        throw;
    }
}

NetcdfFile::~NetcdfFile()
{
    (void)nc_close(m_handle->id);
}

void NetcdfFile::readDimensions()
{
    int count = 0;
    succeed(nc_inq_ndims(m_handle->id, &count), m_subject, {});
    if (count < 0 || static_cast<std::size_t>(count) > kMostDimensions)
        throw Error(ErrorCode::FileTooLarge, m_subject,
                    {{Severity::Error,
                      "dimensions",
                      {IssueId::MostEntries,
                       {countOf(kMostDimensions), static_cast<std::int64_t>(count)}}}});
    for (int i = 0; i < count; ++i) {
        std::array<char, NC_MAX_NAME + 1> name{};
        NetcdfDimension dimension;
        succeed(nc_inq_dim(m_handle->id, i, name.data(), &dimension.size), m_subject, "dimensions");
        dimension.name = name.data();
        m_dimensions.push_back(std::move(dimension));
    }
}

void NetcdfFile::readVariables()
{
    int count = 0;
    succeed(nc_inq_nvars(m_handle->id, &count), m_subject, {});
    if (count < 0 || static_cast<std::size_t>(count) > kMostVariables)
        throw Error(ErrorCode::FileTooLarge, m_subject,
                    {{Severity::Error,
                      "variables",
                      {IssueId::MostEntries,
                       {countOf(kMostVariables), static_cast<std::int64_t>(count)}}}});
    for (int i = 0; i < count; ++i) {
        std::array<char, NC_MAX_NAME + 1> name{};
        NetcdfVariable variable{.number = m_variables.size()};
        nc_type type = NC_NAT;
        int dimensions = 0;
        succeed(nc_inq_varname(m_handle->id, i, name.data()), m_subject, "variables");
        variable.name = name.data();
        succeed(nc_inq_vartype(m_handle->id, i, &type), m_subject, variable.name);
        succeed(nc_inq_varndims(m_handle->id, i, &dimensions), m_subject, variable.name);
        variable.isNumeric = isNumber(type) && dimensions >= 0 &&
                             static_cast<std::size_t>(dimensions) <= kMostDimensionsOfOne;
        if (variable.isNumeric) {
            std::array<int, kMostDimensionsOfOne> ids{};
            succeed(nc_inq_vardimid(m_handle->id, i, ids.data()), m_subject, variable.name);
            for (int d = 0; d < dimensions; ++d) {
                const auto id = static_cast<std::size_t>(ids[static_cast<std::size_t>(d)]);
                if (id >= m_dimensions.size()) // those of groups have other numbers
                    failNetcdf(m_subject, variable.name, NC_EBADDIM);
                variable.dimensions.push_back(id);
            }
            variable.defaultFill = defaultFillOf(type);
            variable.valueBytes = bytesOf(type);
        }
        m_variables.push_back(std::move(variable));
    }
}

std::optional<std::string> NetcdfFile::text(const NetcdfVariable* variable, const char* name) const
{
    const int id = variable == nullptr ? NC_GLOBAL : static_cast<int>(variable->number);
    nc_type type = NC_NAT;
    std::size_t length = 0;
    if (nc_inq_att(m_handle->id, id, name, &type, &length) != NC_NOERR || length == 0)
        return std::nullopt;
    const std::string field = variable == nullptr ? name : variable->name;
    if (type == NC_CHAR && length <= kLongestText) {
        std::string value(length, '\0');
        succeed(nc_get_att_text(m_handle->id, id, name, value.data()), m_subject, field);
        value.erase(value.find_last_not_of(std::string_view(" \0\n", 3)) + 1);
        return value;
    }
    if (type == NC_STRING && length == 1) {
        char* read = nullptr;
        succeed(nc_get_att_string(m_handle->id, id, name, &read), m_subject, field);
        std::string value = read == nullptr ? "" : read;
        (void)nc_free_string(1, &read);
        value.resize(std::min(value.size(), kLongestText));
        return value;
    }
    return std::nullopt;
}

std::vector<double> NetcdfFile::numbers(const NetcdfVariable& variable, const char* name) const
{
    nc_type type = NC_NAT;
    std::size_t length = 0;
    const int id = static_cast<int>(variable.number);
    if (nc_inq_att(m_handle->id, id, name, &type, &length) != NC_NOERR || !isNumber(type) ||
        length == 0 || length > kMostNumbers)
        return {};
    std::vector<double> values(length);
    const int status = nc_get_att_double(m_handle->id, id, name, values.data());
    if (status != NC_ERANGE)
        succeed(status, m_subject, variable.name);
    return values;
}

std::vector<double> NetcdfFile::read(const NetcdfVariable& variable,
                                     std::span<const std::size_t> start,
                                     std::span<const std::size_t> count) const
{
    require(variable.isNumeric && start.size() == variable.dimensions.size() &&
                count.size() == start.size(),
            "NetcdfFile::read: dimensions");
    std::size_t size = 1;
    for (std::size_t i = 0; i < count.size(); ++i) {
        require(start[i] + count[i] <= m_dimensions[variable.dimensions[i]].size,
                "NetcdfFile::read: range");
        require(count[i] == 0 || size <= std::numeric_limits<std::size_t>::max() / count[i],
                "NetcdfFile::read: too large");
        size *= count[i];
    }
    const int id = static_cast<int>(variable.number);
    // One chunk is unpacked at a time, whatever part of it is needed.
    std::array<std::size_t, kMostDimensionsOfOne> chunk{};
    int storage = NC_CONTIGUOUS;
    if (!variable.dimensions.empty() &&
        nc_inq_var_chunking(m_handle->id, id, &storage, chunk.data()) == NC_NOERR &&
        storage == NC_CHUNKED) {
        const std::size_t most = readLimit(std::size_t{256} << 20U);
        std::size_t bytes = variable.valueBytes;
        for (std::size_t i = 0; i < variable.dimensions.size(); ++i) {
            if (chunk[i] == 0 || bytes > most / chunk[i])
                failTooLarge(m_subject, IssueId::TooMuchMemory, most / 1'000'000);
            bytes *= chunk[i];
        }
        (void)nc_set_var_chunk_cache(m_handle->id, id, std::max<std::size_t>(2 * bytes, 32U << 20U),
                                     1009, 0.75F);
    }
    std::vector<double> values(size);
    const int status =
        nc_get_vara_double(m_handle->id, id, start.data(), count.data(), values.data());
    if (status != NC_ERANGE) // which an integer too large gives; such a value is out of range
        succeed(status, m_subject, variable.name);
    return values;
}

} // namespace berg
