using System.Globalization;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;

namespace Msisf.Benchmarks.Definitions;

/// <summary>One picture that is measured, 1024 x 1024 px with a field of view of 40 degrees.</summary>
internal sealed record Scene
{
    public const int Side = 1024; // px
    public const double FieldOfViewDegrees = 40.0;

    /// <summary>As on the command line and in the tables, e.g. "far-4".</summary>
    public required string Name { get; init; }

    /// <summary>What it shows.</summary>
    public required string About { get; init; }

    /// <summary>The elevation model.</summary>
    public required int PixelsPerDegree { get; init; }

    /// <summary>When, where and how the camera looks; the Sun follows from the time.</summary>
    public required SpacecraftState State { get; init; }

    /// <summary>No coarser levels of the model (<c>--lod off</c>).</summary>
    public bool IsExact { get; init; }

    /// <summary>How POV-Ray is measured beside it.</summary>
    public required PovRayUse PovRay { get; init; }

    public required SceneTargets Targets { get; init; }

    public PinholeCamera Camera => CameraAt(State.PositionMoonMe, State.MoonFromCamera);

    public static PinholeCamera CameraAt(Vector3D positionMoonMe, UnitQuaternion moonFromCamera) =>
        new(positionMoonMe, moonFromCamera, double.DegreesToRadians(FieldOfViewDegrees), Side, Side);

    /// <summary>The eight numbers of <c>--fixed-state</c>.</summary>
    public string FixedState
    {
        get
        {
            Vector3D r = State.PositionMoonMe;
            UnitQuaternion q = State.MoonFromCamera;
            return string.Create(
                CultureInfo.InvariantCulture, $"{{{State.Time.Days:R},{r.X:R},{r.Y:R},{r.Z:R},{q.X:R},{q.Y:R},{q.Z:R},{q.W:R}}}");
        }
    }
}
