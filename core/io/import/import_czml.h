#pragma once

#include "core/io/import/import_formats.h"

namespace berg {

/**
 * CZML: packets with a place, and those that move with one sighting for each sample. The iceberg is
 * the packet's name, else its id; a sighting's line is the number of its packet, from 1. Of an
 * export of our own the icebergs are taken with their drift, and area, asset and UAVs as the scene;
 * ways are passed over.
 */
[[nodiscard]] SightingTable readCzml(const ImportText& source);
[[nodiscard]] bool isCzml(std::string_view text);

} // namespace berg
