#pragma once

#include "core/io/results/result_csv.h"
#include "core/io/text/atomic_file.h"
#include "core/io/text/file_set.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>

namespace berg::cli {

/** A folder to write into. It is created if missing, and removed again if nothing was written. */
class OutputFolder
{
public:
    explicit OutputFolder(const std::string& path);
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;
    ~OutputFolder();

private:
    std::filesystem::path m_path;
    std::filesystem::path m_made; ///< outermost folder that was created; empty if all existed
};

/**
 * The files of a flight. Its tables are written during the flight, so that memory does not grow
 * with its length, and get their final names with the other files at the end. The other files are
 * written in pieces as well.
 */
class FlightFiles
{
public:
    static constexpr std::array<std::string_view, 5> kNames{
        "trajectory.csv", "sigma.csv", "zeta.csv", "events.csv", "run.bergrun"};

    /** `changes` are the interventions during the flight. */
    FlightFiles(const std::string& folder, const Scenario& scenario,
                std::span<const Intervention> changes);

    [[nodiscard]] SampleSink sink();
    /** Adds the files that need the whole mission. */
    void add(const Mission& mission);
    [[nodiscard]] FileSet& set() { return m_set; }

private:
    OutputFolder m_folder;
    SampleTables m_tables;
    std::string m_prefix;
    std::string m_rows;
    FileSet m_set;
    StagedFile& m_trajectory;
    StagedFile& m_sigma;
    StagedFile& m_zeta;
};

} // namespace berg::cli
