using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Scene;
using Msisf.Core.Sensitivity;

namespace Msisf.Core.Tests.Sensitivity;

/// <summary>
/// Derivatives of an image by central differences of shifted drawings with many samples. Shares nothing with
/// <see cref="SensitivityFinder"/> but the renderer and the camera.
/// </summary>
/// <param name="pieces">Each pixel is drawn as so many pixels along its edge, of 256 samples each.</param>
internal sealed class DifferencedImages(
    NativeRenderer renderer, FrameCamera camera, SceneLight light, NativeRenderOptions options, int pieces)
{
    private const int SamplesPerAxis = 16;

    /// <summary>px: how far the fastest place of the image moves with a step where brightness is smooth.</summary>
    private const double SmoothStep = 0.01;

    /// <summary>px: the same at edges, where a difference of samples is off by a part of a sample's distance over this.</summary>
    private const double StepOfEdges = 0.2;

    /// <summary>The derivative for pixels in which brightness is smooth.</summary>
    /// <param name="speed">px per unit of the parameter: about the greatest motion of the image.</param>
    public double[] WithoutEdges(Parameter parameter, double speed) => Central(parameter, SmoothStep / speed);

    /// <summary>The derivative for sums over pixels with edges.</summary>
    /// <inheritdoc cref="WithoutEdges"/>
    public double[] WithEdges(Parameter parameter, double speed) => Central(parameter, StepOfEdges / speed);

    private double[] Central(Parameter parameter, double step)
    {
        double[] after = Draw(parameter, step);
        double[] before = Draw(parameter, -step);
        return [.. after.Zip(before, (a, b) => (a - b) / (2.0 * step))];
    }

    private double[] Draw(Parameter parameter, double by)
    {
        Vector3D axis = parameter.Axis switch
        {
            0 => Vector3D.UnitX,
            1 => Vector3D.UnitY,
            _ => Vector3D.UnitZ,
        };
        CameraModel model = camera.Model;
        CameraState state = camera.State;
        SceneLight sun = light;
        switch (parameter.Kind)
        {
            case ParameterKind.Position:
                state = state with { PositionBodyFixed = state.PositionBodyFixed + (by * (state.MoonFromCamera * axis)) };
                break;
            case ParameterKind.Turn:
                state = state with { MoonFromCamera = state.MoonFromCamera * UnitQuaternion.FromAxisAngle(axis, by) };
                break;
            case ParameterKind.FocalLength:
                double scale = (model.FocalX + by) / model.FocalX;
                model = new CameraModel(
                    model.Width, model.Height, (model.FocalX * scale, model.FocalY * scale), (model.PrincipalX, model.PrincipalY),
                    model.Skew * scale, model.Distortion);
                break;
            case ParameterKind.Principal:
                model = new CameraModel(
                    model.Width, model.Height, (model.FocalX, model.FocalY),
                    (model.PrincipalX + (by * axis.X), model.PrincipalY + (by * axis.Y)), model.Skew, model.Distortion);
                break;
            case ParameterKind.Sun:
                Vector3D east = Vector3D.Cross(Vector3D.UnitZ, light.PositionBodyFixed).Normalized();
                Vector3D turn = parameter.Axis == 0 ? Vector3D.Cross(light.PositionBodyFixed, east) : -east;
                sun = light with { PositionBodyFixed = UnitQuaternion.FromAxisAngle(turn, by) * light.PositionBodyFixed };
                break;
            default:
                throw new ArgumentOutOfRangeException(nameof(parameter), parameter, "It moves nothing.");
        }

        // Smaller pixels: a camera whose numbers are written out here.
        CameraModel drawn = new(
            model.Width * pieces, model.Height * pieces, (model.FocalX * pieces, model.FocalY * pieces),
            (((model.PrincipalX - 0.5) * pieces) + 0.5, ((model.PrincipalY - 0.5) * pieces) + 0.5), model.Skew * pieces, model.Distortion);
        using NativeFrame frame = renderer.Render(
            drawn.At(state), sun, options with { SubsamplesPerAxis = SamplesPerAxis, KeepGroundTruth = false }, 2);
        double[] image = new double[model.Width * model.Height];
        for (int i = 0; i < frame.RadianceFactors.Length; i++)
        {
            int row = i / drawn.Width / pieces;
            int column = i % drawn.Width / pieces;
            image[(row * model.Width) + column] += frame.RadianceFactors[i] / (pieces * pieces);
        }

        return image;
    }
}
