using Msisf.App.Settings.Specs;
using Msisf.Core.Attitude;
using Msisf.Core.Orbit;
using Msisf.Core.Scene;
using Msisf.Core.Time;

namespace Msisf.App.Settings;

/// <summary>Where the camera of each image is, in one of the ways of thesis section 6.3.</summary>
internal abstract record CameraSettings;

/// <summary>One image.</summary>
/// <param name="State">Its time, position and orientation.</param>
internal sealed record FixedStateSettings(SpacecraftState State) : CameraSettings;

/// <summary>An image for each line of a file.</summary>
/// <param name="Path">The file; "-" for standard input.</param>
/// <param name="Option">The option that named it, for messages.</param>
internal sealed record BatchFileSettings(string Path, PathSpec Option) : CameraSettings
{
    /// <summary>Whether the states come from standard input, which can be read only once.</summary>
    public bool IsStandardInput => Path == "-";
}

/// <summary>Images along an orbit.</summary>
/// <param name="Elements">Orbital elements at the epoch.</param>
/// <param name="Epoch">Epoch of the elements, UTC.</param>
/// <param name="Frame">Reference frame of the elements.</param>
/// <param name="Attitude">Attitude from the epoch on; null to point the camera at the nadir.</param>
/// <param name="Times">Times of the images, UTC; may be empty.</param>
internal sealed record OrbitSettings(
    KeplerElements Elements, ModifiedJulianDate Epoch, OrbitFrame Frame, AttitudeTransition? Attitude,
    IEnumerable<ModifiedJulianDate> Times) : CameraSettings;
