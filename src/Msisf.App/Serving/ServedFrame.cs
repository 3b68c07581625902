using Msisf.Adapters.Camera;
using Msisf.Core.Scene;

namespace Msisf.App.Serving;

/// <summary>A frame on the viewer's time line.</summary>
/// <param name="Number">From 1.</param>
/// <param name="State">Where and when.</param>
/// <param name="Options">Its other options as a request has them, by their names without dashes.</param>
/// <param name="Files">Paths of its stored files by kind: image, annotated, meta; none for a line of a batch file.</param>
/// <param name="Camera">The camera that its options name; null if they name none, or one that was not found.</param>
internal sealed record ServedFrame(
    int Number, SpacecraftState State, IReadOnlyDictionary<string, string> Options, IReadOnlyDictionary<string, string> Files,
    CameraFile? Camera = null);
