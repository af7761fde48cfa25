// AIS by npm packages that share no code with ours: `encode` makes sentences of JSON lines
// (ggencoder), `decode` makes JSON lines of sentences (ais-stream-decoder, ggencoder).
"use strict";

const modules = process.env.BERGWATCH_NODE_MODULES;
const { AisEncode, AisDecode } = require(modules + "/ggencoder");
const AisStream = require(modules + "/ais-stream-decoder").default;

const lines = require("fs").readFileSync(0, "utf8").split("\n").filter((line) => line);
if (process.argv[2] === "encode") {
  for (const line of lines) console.log(new AisEncode(JSON.parse(line)).nmea);
} else {
  const stream = new AisStream({ silent: true });
  stream.on("data", (text) => {
    const m = JSON.parse(text);
    console.log(JSON.stringify({ by: "stream", type: m.type, mmsi: m.mmsi, lat: m.lat, lon: m.lon,
      sog: m.speedOverGround, cog: m.courseOverGround, hdg: m.heading, name: m.name }));
  });
  stream.on("error", () => {});
  for (const line of lines) stream.write(line);
  for (const line of lines) {
    const m = new AisDecode(line);
    if (m.valid)
      console.log(JSON.stringify({ by: "gg", type: m.aistype, mmsi: Number(m.mmsi), lat: m.lat,
        lon: m.lon, sog: m.sog, cog: m.cog, hdg: m.hdg, name: m.shipname || m.atonname }));
  }
}
