// MAVLink over UDP by the npm package node-mavlink, which shares no code with Bergwatch. The
// package is looked for in the folder BERGWATCH_NODE_MODULES.
'use strict';
const dgram = require('dgram');
const path = require('path');
const {createRequire} = require('module');
const modules = createRequire(path.join(process.env.BERGWATCH_NODE_MODULES, 'x'));
const {MavLinkPacketSplitter, MavLinkPacketParser, MavLinkProtocolV2, minimal, standard, common, ardupilotmega} =
    modules('node-mavlink');
const registry = {...minimal.REGISTRY, ...standard.REGISTRY, ...common.REGISTRY, ...ardupilotmega.REGISTRY};

// A socket with its own system id that exchanges messages with 127.0.0.1:port. `loss` is the share
// of datagrams dropped at random in each direction; onMessage gets (message, header).
class NodeLink {
    constructor({port, system, component, loss = 0, seed = 1, onMessage}) {
        this.port = port;
        this.loss = loss;
        this.state = seed;
        this.sequence = 0;
        this.datagrams = 0;
        this.protocol = new MavLinkProtocolV2(system, component);
        this.socket = dgram.createSocket('udp4');
        const splitter = new MavLinkPacketSplitter();
        const parser = new MavLinkPacketParser();
        splitter.pipe(parser);
        parser.on('data', packet => {
            const type = registry[packet.header.msgid];
            if (type)
                onMessage(packet.protocol.data(packet.payload, type), packet.header);
        });
        this.socket.on('message', bytes => {
            ++this.datagrams;
            if (!this.isLost())
                splitter.write(bytes);
        });
        this.socket.bind(0, '127.0.0.1');
    }

    random() { // Park and Miller's generator
        this.state = this.state * 48271 % 2147483647;
        return this.state / 2147483647;
    }

    isLost() { return this.random() < this.loss; }

    send(Type, fields) {
        const bytes = this.protocol.serialize(Object.assign(new Type(), fields), this.sequence);
        this.sequence = (this.sequence + 1) % 256;
        if (!this.isLost())
            this.socket.send(bytes, this.port, '127.0.0.1');
    }
}

module.exports = {NodeLink, minimal, common};
