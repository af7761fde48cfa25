// A vehicle for Bergwatch's ground station:
//   node vehicle.cjs PORT ardupilot|px4 LOSS SEED
// It stores lists of items as the autopilot does and answers requests for them. On standard output
// it reports each list as JSON once it is complete; to each line on standard input it answers with
// the number of datagrams received so far.
'use strict';
const {NodeLink, minimal, common} = require('./node_link.cjs');
const [port, kind, loss, seed] = process.argv.slice(2);
const isPx4 = kind === 'px4';
const retry_ms = isPx4 ? 500 : 1000;
const lists = [[], [], []];
let upload = null; // {type, count, items, partner}

const link = new NodeLink({port: +port, system: 1, component: 1, loss: +loss, seed: +seed, onMessage});

function request() {
    // ArduPilot asks with the old message.
    const Type = isPx4 ? common.MissionRequestInt : common.MissionRequest;
    link.send(Type, {...upload.partner, seq: upload.items.length, missionType: upload.type});
    clearTimeout(upload.timer);
    upload.timer = setTimeout(request, retry_ms);
}

function complete() {
    clearTimeout(upload.timer);
    lists[upload.type] = upload.items;
    link.send(common.MissionAck, {...upload.partner, type: 0, missionType: upload.type});
    console.log(JSON.stringify({type: upload.type, items: upload.items}));
    upload = null;
}

function onMessage(message, header) {
    const partner = {targetSystem: header.sysid, targetComponent: header.compid};
    const name = message.constructor.MSG_NAME;
    if (name === 'MISSION_COUNT') {
        if (upload)
            clearTimeout(upload.timer);
        upload = {type: message.missionType, count: message.count, items: [], partner};
        if (message.count === 0)
            complete();
        else
            request();
    } else if (name === 'MISSION_ITEM_INT' && upload && message.seq === upload.items.length) {
        upload.items.push(message);
        if (upload.items.length === upload.count)
            complete();
        else
            request();
    } else if (name === 'MISSION_REQUEST_LIST') {
        link.send(common.MissionCount, {...partner, count: lists[message.missionType].length,
                                        missionType: message.missionType});
    } else if (name === 'MISSION_REQUEST_INT') {
        const item = lists[message.missionType][message.seq];
        if (item)
            link.send(common.MissionItemInt, {...item, ...partner});
    } else if (name === 'COMMAND_LONG' || name === 'COMMAND_INT') {
        link.send(common.CommandAck, {...partner, command: message.command, result: 0});
    }
}

setInterval(() => link.send(minimal.Heartbeat, {type: 1, autopilot: isPx4 ? 12 : 3, baseMode: 157,
                                                customMode: 10, systemStatus: 4, mavlinkVersion: 3}), 250);
process.stdin.on('data', () => console.log(JSON.stringify({datagrams: link.datagrams})));
process.stdin.on('end', () => process.exit(0));
