// What a run of the renderer left, and what belongs to what in it. Nothing here is drawn, and no array decoded
// before it is asked for.

class Run {
  constructor(json, index, blobs) {
    Object.assign(this, json);
    for (const list of ["effects", "passes", "skipped", "attachments", "histories", "lights", "meshes", "sweeps",
      "left_out", "notes"]) this[list] = json[list] ?? [];
    this.index = index;
    this.blobs = blobs;
    for (const attachment of this.attachments) attachment.label ??= attachment.texture;
    this.byId = new Map(this.attachments.map((attachment) => [attachment.id, attachment]));
    this.byLabel = new Map(this.passes.map((pass, number) => [pass.label, number]));
  }

  attachment(id) {
    return this.byId.get(id) ?? null;
  }

  attachmentsOf(passNumber) {
    return (this.passes[passNumber]?.writes ?? []).map((id) => this.attachment(id)).filter(Boolean);
  }

  historyOf(passNumber) {
    return this.histories.find((history) => history.pass === passNumber) ?? null;
  }

  // The texture as the last pass before this one left it.
  attachmentBefore(passNumber, texture) {
    let found = null;
    for (const attachment of this.attachments) {
      if (attachment.texture !== texture || attachment.pass >= passNumber) continue;
      if (!found || attachment.pass >= found.pass) found = attachment;
    }
    return found;
  }

  // The passes that made a texture as this pass finds it: the last that wrote it, and all that it added to.
  makersOf(passNumber, texture) {
    const makers = [];
    let found = this.attachmentBefore(passNumber, texture);
    while (found) {
      makers.push(found.pass);
      const blends = this.passes[found.pass].state?.blend;
      found = blends ? this.attachmentBefore(found.pass, texture) : null;
    }
    return makers;
  }

  readersOf(passNumber) {
    return this.passes.map((pass, number) => number).filter((number) => number > passNumber &&
      (this.passes[number].reads ?? []).some((texture) => this.makersOf(number, texture).includes(passNumber)));
  }

  // The finished picture: the last attachment for a screen, else the last with data.
  picture() {
    const held = this.attachments.filter((attachment) => attachment.data);
    return held.findLast((attachment) => attachment.kind === "display") ?? held.at(-1) ?? null;
  }

  async values(attachment) {
    return attachment ? this.blobs.get(attachment.data) : null;
  }
}

class Recording {
  constructor(json) {
    this.program = json.program ?? "";
    this.blobs = new Blobs();
    this.runs = (json.runs ?? []).map((run, index) => new Run(run, index, this.blobs));
  }
}

// How many numbers a texel has in the page.
function channelsOf(attachment) {
  const count = attachment.data ? attachment.data.count / (attachment.width * attachment.height) : 0;
  return Math.round(count) || (attachment.channels ?? []).length || 1;
}

function channelName(attachment, channel) {
  return attachment.channels?.[channel]?.name ?? ["x", "y", "z", "w"][channel] ?? String(channel);
}

function lightOf(run, pass) {
  return pass && pass.light !== null && pass.light !== undefined ? run.lights[pass.light] ?? null : null;
}
