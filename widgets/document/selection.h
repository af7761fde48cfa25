#pragma once

#include <QObject>

#include <optional>
#include <string>
#include <vector>

namespace berg {

struct Scenario;

// Selection keys of objects without an id. They are not valid UTF-8, unlike ids, so that no id
// equals one of them.
inline constexpr char kAssetKey[] = "\xFF"
                                    "asset";
inline constexpr char kAreaKey[] = "\xFF"
                                   "area";

// No-fly areas have no ids and are selected by their index in the list.
[[nodiscard]] std::string noFlyKey(std::size_t place);
/** Returns the index of a no-fly area, or nullopt for other keys. */
[[nodiscard]] std::optional<std::size_t> noFlyPlace(const std::string& key);
/** Returns whether the key is that of the area or of a no-fly area. */
[[nodiscard]] bool isOutlineKey(const std::string& key);

/**
 * Objects that map, tables and Inspector act on: icebergs and UAVs by id, asset and areas by key,
 * in the order of selection. GUI thread.
 */
class Selection : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] const std::vector<std::string>& ids() const { return m_ids; }
    [[nodiscard]] bool contains(const std::string& id) const;
    [[nodiscard]] bool isEmpty() const { return m_ids.empty(); }

    /** Selects these ids only; duplicates count once. */
    void set(std::vector<std::string> ids);
    void toggle(const std::string& id);
    void clear();
    /**
     * Deselects what is not in the scenario, and all no-fly areas if their number changed, because
     * their indices have shifted.
     */
    void keepExisting(const Scenario& scenario);

signals:
    /** Emitted when the ids or their order have changed. */
    void changed();

private:
    std::vector<std::string> m_ids;
    std::size_t m_noFlyAreas = 0; ///< number at the last `keepExisting`
};

} // namespace berg
