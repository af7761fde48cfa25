#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

struct NetcdfDimension
{
    std::string name;
    std::size_t size = 0;
};

/** A variable of the root group. */
struct NetcdfVariable
{
    std::size_t number = 0; ///< index in `NetcdfFile::variables`
    std::string name;
    std::vector<std::size_t> dimensions; ///< indices in `NetcdfFile::dimensions`
    bool isNumeric = false;              ///< false for text, structures and many dimensions
    /** Value that marks what was never written, unless an attribute names another. */
    std::optional<double> defaultFill;
    std::size_t valueBytes = 0;
};

/**
 * A NetCDF file in memory, read through libnetcdf. The library is no judge of hostile bytes: sizes
 * are checked before each call, and `runIsolated` bounds what then still goes wrong. Every function
 * throws `Error` with the name of the file and the variable.
 */
class NetcdfFile
{
public:
    /** Opens a file whose bytes must outlive it. Throws `Error{FileUnreadable}`. */
    NetcdfFile(std::string_view bytes, std::string subject);
    NetcdfFile(const NetcdfFile&) = delete;
    NetcdfFile& operator=(const NetcdfFile&) = delete;
    ~NetcdfFile();

    [[nodiscard]] const std::string& subject() const { return m_subject; }
    [[nodiscard]] const std::vector<NetcdfDimension>& dimensions() const { return m_dimensions; }
    [[nodiscard]] const std::vector<NetcdfVariable>& variables() const { return m_variables; }

    /** Returns a text attribute of a variable, or of the file if it is null; nullopt for none. */
    [[nodiscard]] std::optional<std::string> text(const NetcdfVariable* variable,
                                                  const char* name) const;
    /** Returns the numbers of an attribute, at most 16; empty if it is missing or text. */
    [[nodiscard]] std::vector<double> numbers(const NetcdfVariable& variable,
                                              const char* name) const;
    /**
     * Returns `count` values of each dimension from `start` on, the last dimension fastest, as they
     * are in the file. Requires ranges within the dimensions and a numeric variable.
     */
    [[nodiscard]] std::vector<double> read(const NetcdfVariable& variable,
                                           std::span<const std::size_t> start,
                                           std::span<const std::size_t> count) const;

private:
    struct Handle;

    void readDimensions();
    void readVariables();

    std::string m_subject;
    std::size_t m_size;
    std::unique_ptr<Handle> m_handle;
    std::vector<NetcdfDimension> m_dimensions;
    std::vector<NetcdfVariable> m_variables;
};

} // namespace berg
