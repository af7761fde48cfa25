#include "app/cli/flight_files.h"

#include "core/io/files/run_json.h"

#include <algorithm>

namespace berg::cli {

namespace fs = std::filesystem;

OutputFolder::OutputFolder(const std::string& path) : m_path(path)
{
    std::error_code failure;
    for (fs::path folder = fs::absolute(path, failure).lexically_normal();
         !fs::exists(folder, failure) && folder.has_relative_path(); folder = folder.parent_path())
        m_made = folder;
    fs::create_directories(m_path, failure);
    if (failure)
        throw Error(ErrorCode::FileUnwritable, path, {IssueId::CannotWrite, {failure.message()}});
}

OutputFolder::~OutputFolder()
{
    std::error_code failure; // also: there is something in it
    for (fs::path folder = fs::absolute(m_path, failure).lexically_normal();
         !m_made.empty() && fs::remove(folder, failure) && folder != m_made;)
        folder = folder.parent_path();
}

FlightFiles::FlightFiles(const std::string& folder, const Scenario& scenario,
                         std::span<const Intervention> changes)
    : m_folder(folder)
    , m_tables(sampleTables(scenario, changes))
    , m_prefix(folder + '/')
    , m_trajectory(m_set.add(m_prefix + "trajectory.csv"))
    , m_sigma(m_set.add(m_prefix + "sigma.csv"))
    , m_zeta(m_set.add(m_prefix + "zeta.csv"))
{
    m_trajectory.append(m_tables.trajectoryHeader());
    m_sigma.append(m_tables.sigmaHeader());
    m_zeta.append(m_tables.zetaHeader());
}

SampleSink FlightFiles::sink()
{
    return [this](const Sample& sample, std::span<const IcebergSample> icebergs) {
        const auto put = [this](StagedFile& file, const auto& addRows) {
            m_rows.clear();
            addRows(m_rows);
            file.append(m_rows);
        };
        put(m_trajectory, [&](std::string& rows) { m_tables.addTrajectory(rows, sample); });
        put(m_sigma, [&](std::string& rows) { m_tables.addSigma(rows, sample, icebergs); });
        put(m_zeta, [&](std::string& rows) { m_tables.addZeta(rows, sample); });
    };
}

void FlightFiles::add(const Mission& mission)
{
    StagedFile& events = m_set.add(m_prefix + "events.csv");
    writeEvents(mission, [&events](std::string_view piece) { events.append(piece); });
    StagedFile& run = m_set.add(m_prefix + "run.bergrun");
    writeRun(runOf(mission), [&run](std::string_view piece) { run.append(piece); });
}

} // namespace berg::cli
