#include "core/io/files/run_keyframe.h"
#include "core/io/text/json_writer.h"
#include "core/scenario/limits.h"

#include <algorithm>

// Fixes of real aircraft in a run file.

namespace berg {

std::string fixText(const PoseFix& fix)
{
    JsonObject object;
    object.add("time_s", fix.time_s);
    object.addUnless("uav", fix.uav, 0);
    object.add("position_m", fix.pose.position_m);
    object.add("psi_rad", fix.pose.psi_rad);
    object.addUnless("measured", fix.isMeasured, true);
    object.addUnless("first", fix.isFirst, false);
    return object.inLine();
}

std::vector<PoseFix> readFixes(ObjectReader& run, const RunContext& context)
{
    std::vector<double> last_s(std::max<std::size_t>(1, context.uavs), 0);
    return readEach(run, "fixes", [&](const Json& value, const std::string& path) {
        ObjectReader object(value, path, run.faults());
        PoseFix fix;
        fix.uav = asInt(object.whole(
            "uav", 0, {.low = 0, .high = static_cast<std::int64_t>(context.uavs) - 1}));
        double& before_s = last_s[static_cast<std::size_t>(fix.uav)];
        fix.isFirst = object.boolean("first", false);
        fix.time_s = object.number("time_s", before_s, limits::kTime_s);
        if (fix.time_s <= before_s)
            object.faults().add(object.path("time_s"), {IssueId::NotRising});
        if (before_s == 0 && !fix.isFirst)
            object.faults().add(object.path("first"), {IssueId::NotOneOf, {"true"}});
        before_s = std::max(before_s, fix.time_s);
        fix.pose.position_m = object.point("position_m", Point::Zero());
        for (std::size_t axis = 0; axis < 2; ++axis)
            if (auto fault = outOfLimits(fix.pose.position_m[static_cast<Eigen::Index>(axis)],
                                         limits::kCoordinate_m))
                object.faults().add(entryPath(object.path("position_m"), axis), std::move(*fault));
        fix.pose.psi_rad = object.number("psi_rad", 0, Limits{.low = -4, .high = 4});
        fix.isMeasured = object.boolean("measured", true);
        return fix;
    });
}

} // namespace berg
