using Msisf.App.Preparation;
using Msisf.Core.Scene;

namespace Msisf.App.Serving;

/// <summary>A frame that can be drawn.</summary>
/// <param name="State">Its state.</param>
/// <param name="Frame">Its camera and light.</param>
internal sealed record PreparedFrame(SpacecraftState State, Frame Frame);
