using System.Globalization;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;

namespace Msisf.Benchmarks.Definitions;

/// <summary>One image that is measured, square with a field of view of 40 degrees.</summary>
internal sealed record Scene
{
    /// <summary>px.</summary>
    public const int DefaultSide = 1024;

    public const double FieldOfViewDegrees = 40.0;

    /// <summary>As on the command line and in the tables, e.g. "far-4".</summary>
    public required string Name { get; init; }

    /// <summary>Width and height, px.</summary>
    public int Side { get; init; } = DefaultSide;

    /// <summary>What it shows.</summary>
    public required string About { get; init; }

    /// <summary>The elevation model: of the whole Moon by its samples a degree, the map of the south pole by its metres a pixel.</summary>
    public required GridResolution Model { get; init; }

    /// <summary>When, where and how the camera looks; the Sun follows from the time.</summary>
    public required SpacecraftState State { get; init; }

    /// <summary>The native renderer's frames are timed without coarser levels of the model (<c>--lod off</c>).</summary>
    public bool IsExact { get; init; }

    /// <summary>What the native renderer's frames may cost; null if its frames are not timed one by one.</summary>
    public SceneTargets? Targets { get; init; }

    /// <summary>The ways whose time and error are measured; none if they are not.</summary>
    public IReadOnlyList<Setting> Settings { get; init; } = [];

    /// <summary>
    /// Tiles of the image that are measured in the thesis's way; with fewer than it takes its time is scaled, and it has no error.
    /// </summary>
    public int MaxThesisTiles { get; init; } = int.MaxValue;

    /// <summary>Its truth can be drawn: 64 samples of the full model. At 512 px/deg that would take ten minutes.</summary>
    public bool HasTruth { get; init; } = true;

    public PinholeCamera Camera => CameraAt(State.PositionBodyFixed, State.MoonFromCamera);

    public PinholeCamera CameraAt(Vector3D positionBodyFixed, UnitQuaternion moonFromCamera) =>
        new(positionBodyFixed, moonFromCamera, double.DegreesToRadians(FieldOfViewDegrees), Side, Side);

    /// <summary>The eight numbers of <c>--fixed-state</c>.</summary>
    public string FixedState
    {
        get
        {
            Vector3D r = State.PositionBodyFixed;
            UnitQuaternion q = State.MoonFromCamera;
            return string.Create(
                CultureInfo.InvariantCulture, $"{{{State.Time.Mjd:R},{r.X:R},{r.Y:R},{r.Z:R},{q.X:R},{q.Y:R},{q.Z:R},{q.W:R}}}");
        }
    }
}
