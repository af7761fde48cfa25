#pragma once

#include <QObject>

#include <optional>
#include <string>
#include <vector>

namespace berg {

struct Scenario;

// What there is once and without an id is selected by these. They are no UTF-8, as every id is, so
// that none can be one of them.
inline constexpr char kAssetKey[] = "\xFF"
                                    "asset";
inline constexpr char kAreaKey[] = "\xFF"
                                   "area";

// No-fly areas have no ids: they are selected by their place in the list.
[[nodiscard]] std::string noFlyKey(std::size_t place);
/** None for every other key. */
[[nodiscard]] std::optional<std::size_t> noFlyPlace(const std::string& key);
/** Whether it is that of the area or of a no-fly area. */
[[nodiscard]] bool isOutlineKey(const std::string& key);

/**
 * What map, tables and inspector act on: icebergs and UAVs by id, asset and areas by key, in the
 * order in which they were selected. GUI thread.
 */
class Selection : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] const std::vector<std::string>& ids() const { return m_ids; }
    [[nodiscard]] bool contains(const std::string& id) const;
    [[nodiscard]] bool isEmpty() const { return m_ids.empty(); }

    /** Selects these and nothing else; an id that comes twice counts once. */
    void set(std::vector<std::string> ids);
    void toggle(const std::string& id);
    void clear();
    /** Drops what is not in the scenario; of no-fly areas all when there are more or fewer, as
     * places are not those of before. */
    void keepExisting(const Scenario& scenario);

signals:
    /** Other ids than before, or another order of them. */
    void changed();

private:
    std::vector<std::string> m_ids;
    std::size_t m_noFlyAreas = 0; ///< when it was asked last
};

} // namespace berg
