#pragma once

// Private to core/io: chooses between ids of features and the properties that name icebergs.

#include "core/io/import/fields/import_table.h"
#include "core/io/text/read_budget.h"

#include <string>
#include <vector>

namespace berg {

/**
 * Ids of features that also have a property that names the iceberg.
 *
 * The property is used, and the id of a feature where the property is missing, with two exceptions
 * that apply to the whole file. First, the ids of the features are used if the properties would
 * merge sightings that cannot be one iceberg (two features of different ids with one property at
 * one time, or without a time, at two places; a feature whose own id is another's property); this
 * is noted. Second, they are used if each property occurs once while the ids of features repeat,
 * because such properties number the messages of a tracker.
 */
class FeatureIds
{
public:
    explicit FeatureIds(ReadBudget& budget) : m_budget(budget) {}

    /**
     * Adds the rows of the table from `first` on, which belong to one feature. `isProperty` says
     * whether their ids come from a property.
     */
    void add(const SightingTable& table, std::size_t first, const std::string& featureId,
             bool isProperty);
    /**
     * Replaces the ids by those of the features if these are used for the file, unless the user has
     * mapped a column. Call it once, when all rows are there and before `decideIdentity`.
     */
    void finish(SightingTable& table);

private:
    /** Returns the property of a row; empty if it has none. */
    [[nodiscard]] std::string propertyOf(const SightingTable& table, std::size_t row) const;
    /** Returns a row whose property cannot be an id, or null if there is none. */
    [[nodiscard]] const Sighting* clashing(const SightingTable& table) const;
    /** Returns true if the properties number messages. */
    [[nodiscard]] bool arePropertiesNumbers(const SightingTable& table) const;

    ReadBudget& m_budget;
    std::vector<std::string> m_ids; ///< ids of the features, by row
    std::vector<bool> m_isProperty; ///< whether the id of the row is a property
    bool m_isAny = false;
};

} // namespace berg
